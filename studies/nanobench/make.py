import csv, os, sys
DATA, OUT, LENGTH = '/work/shared/data/nanobench', '/tmp/nb', 0.6
HELD = ['B3_figure8_fast_rep1','B5_helix_fast_rep1','B10_lissajous_fast_rep1','B2_circle_medium_rep1']
os.makedirs(OUT, exist_ok=True)
flights=[]
for f in sorted(os.listdir(DATA)):
    name=f[:-4]
    if 'ramp' in name or not f.endswith('.csv') or name in HELD: continue
    rows=[[float(c) for c in r] for r in list(csv.reader(open(f'{DATA}/{f}')))[1:]]
    start=next(r[0] for r in rows if sum(r[14:18])/4/65535>.2)
    air=[i for i,r in enumerate(rows) if r[3]>.35 and sum(r[14:18])/4/65535>.2]
    rows=rows[air[0]+60:air[-1]-60]
    n=0
    t=rows[0][0]
    while t+LENGTH<rows[-1][0]:
        arc=[r for r in rows if t-.011<=r[0]<=t+LENGTH+.011]
        inside=[r for r in arc if t<=r[0]<=t+LENGTH]
        if inside[-1][0]-inside[0][0]>.9*LENGTH and max(b[0]-a[0] for a,b in zip(arc,arc[1:]))<.035:
            n+=1; nm=f'{name}-{n:02}'
            with open(f'{OUT}/{nm}.csv','w') as o:
                o.write('t,c_x,c_y,c_z\n'); [o.write(f'{r[0]},{r[1]},{r[2]},{r[3]}\n') for r in inside]
            with open(f'{OUT}/{nm}-inputs.csv','w') as o:
                o.write('t,q0,q1,q2,q3,m1,m2,m3,m4,voltage,running\n')
                # commands from half a second before on, for the lag
                pre=[r for r in rows if t-.35<=r[0]<=t+LENGTH+.011]
                for r in pre: o.write(','.join(str(v) for v in [r[0],*r[4:8],*[c/65535 for c in r[14:18]],r[18],r[0]-start])+'\n')
            flights.append(nm)
        t+=float(sys.argv[1]) if len(sys.argv)>1 else LENGTH
with open(f'{OUT}/dataset.toml','w') as o:
    o.write('model = "crazyflie.hyz"\n[[markers]]\nname = "c"\nposition = [0.0, 0.0, 0.0]\n')
    for nm in flights: o.write(f'[[flights]]\nfile = "{nm}.csv"\ninputs = "{nm}-inputs.csv"\n')
os.system(f'cp crazyflie.hyz {OUT}/')
print(len(flights))
