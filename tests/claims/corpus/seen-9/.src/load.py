import os
from lxml import etree
from pymavlink.generator import mavcrc
D='/work/corpus/'
SZ={'uint8_t':1,'int8_t':1,'char':1,'uint8_t_mavlink_version':1,'uint16_t':2,'int16_t':2,'uint32_t':4,'int32_t':4,'float':4,'uint64_t':8,'int64_t':8,'double':8}
def load(f='ardupilotmega.xml',seen=None,M=None,E=None):
    seen=set() if seen is None else seen; M={} if M is None else M; E={} if E is None else E
    if f in seen: return M,E
    seen.add(f)
    r=etree.parse(D+f).getroot()
    for i in r.findall('include'): load(i.text.strip(),seen,M,E)
    for e in r.iter('enum'):
        d=E.setdefault(e.get('name'),{})
        last=-1
        for x in e.findall('entry'):
            v=x.get('value'); v=eval(v) if v is not None else last+1; last=v
            d[x.get('name')]=(v,' '.join((x.findtext('description')or'').split()),[(p.get('index'),p.get('label'),p.get('units'),p.get('enum'),' '.join((p.text or '').split())) for p in x.findall('param')])
    for m in r.iter('message'):
        ext=False; fs=[]; wip=m.find('wip') is not None
        for c in m:
            if c.tag=='extensions': ext=True
            if c.tag=='field':
                t=c.get('type'); n=0
                if '[' in t: t,n=t[:-1].split('['); n=int(n)
                fs.append(dict(name=c.get('name'),type=t,n=n,ext=ext,units=c.get('units'),mult=c.get('multiplier'),enum=c.get('enum'),disp=c.get('display'),inv=c.get('invalid'),min=c.get('minValue'),max=c.get('maxValue'),inst=c.get('instance'),desc=' '.join((''.join(c.itertext())).split())))
        base=sorted([x for x in fs if not x['ext']],key=lambda x:-SZ[x['type']])
        w=base+[x for x in fs if x['ext']]
        o=0
        for x in w: x['off']=o; o+=SZ[x['type']]*max(1,x['n'])
        bl=sum(SZ[x['type']]*max(1,x['n']) for x in base)
        crc=mavcrc.x25crc()
        def acc(s): crc.accumulate(s.encode() if isinstance(s,str) else bytes(s))
        acc(m.get('name')+' ')
        for x in base:
            acc('uint8_t ' if x['type']=='uint8_t_mavlink_version' else x['type']+' '); acc(x['name']+' ')
            if x['n']: acc([x['n']])
        M[m.get('name')]=dict(id=int(m.get('id')),name=m.get('name'),wip=wip,dep=m.find('deprecated') is not None,sup=m.find('superseded') is not None,decl=fs,wire=w,base=bl,full=o,crc=(crc.crc&0xff)^(crc.crc>>8),file=f,desc=' '.join((m.findtext('description')or'').split()))
    return M,E
if __name__=='__main__':
    M,E=load()
    import sys
    for m in sorted(M.values(),key=lambda m:m['id']):
        if len(sys.argv)>1 and m['name'] not in sys.argv[1:]: continue
        print(f"## {m['name']} id={m['id']} crc={m['crc']} base={m['base']} full={m['full']} {m['file']} {'WIP' if m['wip'] else ''}{'DEPR' if m['dep'] else ''}{'SUP' if m['sup'] else ''} | {m['desc'][:160]}")
        if m['wip']: continue
        for x in m['wire']:
            print(f"  @{x['off']} {x['type']}{'['+str(x['n'])+']' if x['n'] else ''} {x['name']}{' EXT' if x['ext'] else ''}{' u='+x['units'] if x['units'] else ''}{' mult='+x['mult'] if x['mult'] else ''}{' e='+x['enum'] if x['enum'] else ''}{' inv='+x['inv'] if x['inv'] else ''}{' min='+x['min'] if x['min'] else ''}{' max='+x['max'] if x['max'] else ''} | {x['desc'][:170]}")
