from load import load
import sys
M,E=load()
for n in sys.argv[1:]:
    if n not in E:
        print("??",n); continue
    print(n,': ',', '.join(f"{k.replace(n+'_','~')}={v[0]}" for k,v in E[n].items()))
