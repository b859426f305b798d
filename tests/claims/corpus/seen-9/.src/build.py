import re,glob,yaml,os
from load import load
M,E=load()
out=[];bad=0
mk=re.compile(r'\{\{(.*?)\|\|(.*?)\}\}')
for p in sorted(glob.glob('p*.txt')):
    for d in re.split(r'^=== ',open(p).read(),flags=re.M)[1:]:
        head,body=d.split('\n',1); f,form,note=[x.strip() for x in head.split(' | ')]
        faults=[];lines=[]
        body=body.strip('\n')
        for i,l in enumerate(body.split('\n'),1):
            for m in mk.finditer(l):
                a=m.group(2).split('|')
                kind,msg,fld,dia=a[:4]; sure=a[4] if len(a)>4 else 'sure'
                faults.append(dict(line=i,kind=kind,message=msg,field=None if fld=='null' else fld,claimed=m.group(1),dialect=dia,sure=sure))
            l2=mk.sub(lambda m:m.group(1),l); lines.append(l2)
        assert '{{' not in '\n'.join(lines) and '||' not in '\n'.join(lines).replace('| |','') , f
        n=len(lines)
        if not 8<=n<=45: print('LEN',f,n)
        open('../'+f,'w').write('\n'.join(lines)+'\n')
        out.append(dict(file=f,form=form,note=note,faults=faults))
yaml.safe_dump(out,open('../labels.yaml','w'),sort_keys=False,allow_unicode=True,width=200)
# verify
from collections import Counter
C=Counter(x['kind'] for d in out for x in d['faults'])
print(len(out),sum(1 for d in out if d['faults']),sum(C.values()),dict(C))
for d in out:
    L=open('../'+d['file']).read().split('\n')
    for x in d['faults']:
        assert x['claimed'] in L[x['line']-1],x
        k=x['kind'];m=M.get(x['message']);fl=None
        if m and x['field']: fl=next((q for q in m['decl'] if q['name']==x['field']),None)
        info=''
        if k=='no-message': info=(m is None, x['dialect'] in M)
        elif k=='no-field': info=(fl is None, any(q['name']==x['dialect'] for q in m['decl']))
        elif fl: info=(fl['type'],fl['n'],'ext' if fl['ext'] else 'base',fl['off'],fl['units'],fl['mult'],fl['enum'],fl['inv'],fl['desc'][:110])
        else: info=(m['id'],m['crc'],m['base'],m['full'])
        if k.startswith('enum-v'):
            e,v=x['dialect'].split('='); info=(E[fl['enum']][e][0]==int(v),)+info[6:7]
        print(d['file'][:2],x['line'],k,x['message'],x['field'],'|',x['claimed'],'->',x['dialect'],'##',info)
names=set()
for d in out:
    t=open('../'+d['file']).read()
    for n in M:
        if re.search(r'(?<![A-Z0-9_])'+n+r'(?![A-Z0-9_])',t): names.add(n)
print(len(names),sorted(names))
print([n for n in names if M[n]['wip']])
