# TRAORI and CYCLE800 on tables, heads and nutating axes: where the tip stands on the workpiece, and how the tool points,
# computed back from the axis positions by chains of their own.
need python3
cat >check.py <<'PYTHON'
import math, os, random, subprocess
def R(axis,a):
    l=math.sqrt(sum(c*c for c in axis)); x,y,z=[c/l for c in axis]; c,s=math.cos(a),math.sin(a); k=1-c
    return [[c+k*x*x,k*x*y-s*z,k*x*z+s*y],[k*x*y+s*z,c+k*y*y,k*y*z-s*x],[k*x*z-s*y,k*y*z+s*x,c+k*z*z]]
T=lambda m:[list(r) for r in zip(*m)]
ap=lambda m,v:[sum(m[i][j]*v[j] for j in range(3)) for i in range(3)]
mul=lambda a,b:[[sum(a[i][k]*b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
def turn(p,axis,loc,a): return [x+y for x,y in zip(ap(R(axis,a),[q-l for q,l in zip(p,loc)]),loc)]
# families: list of (letter, axis, location, on) on table or head; order outermost first
S=math.sqrt(.5)
fam={
 'AC table':[('A',[-1,0,0],[0,3,5],'t'),('C',[0,0,-1],[1,2,0],'t')],
 'BC table':[('B',[0,-1,0],[4,0,7],'t'),('C',[0,0,-1],[0,0,0],'t')],
 'nutating BC table':[('B',[0,S,-S],[0,10,-20],'t'),('C',[0,0,-1],[0,0,0],'t')],
 'CB head':[('C',[0,0,1],[0,0,900],'h'),('B',[0,1,0],[0,5,700],'h')],
 'nutating head B, table C':[('B',[0,S,S],[0,0,600],'h'),('C',[0,0,-1],[3,0,0],'t')],
}
L=120; gauge=[0,0,500]
def xml(name,rot):
    lin='<axis name="X" type="linear" direction="1 0 0" limit_min="-9999" limit_max="9999" rate_max="6000"><axis name="Y" type="linear" direction="0 1 0" limit_min="-9999" limit_max="9999" rate_max="6000"><axis name="Z" type="linear" direction="0 0 1" limit_min="-9999" limit_max="9999" rate_max="6000">'
    ax=lambda r:'<axis name="%s" type="rotary" direction="%.17g %.17g %.17g" location="%g %g %g" limit_min="-9999" limit_max="9999" rate_max="3600">'%(r[0],*r[1],*r[2])
    h=[r for r in rot if r[3]=='h']; t=[r for r in rot if r[3]=='t']
    s='<machine version="1" name="t" units="mm"><controller dialect="sinumerik" rapid="linear" path_tolerance="0.01" frames_outlive_traori="yes" swivel_axis="%s"><tool_change/></controller><base>'%([r[0] for r in rot if r[0]!='C'][0])
    s+=lin+''.join(map(ax,h))+'<spindle location="%g %g %g" direction="0 0 -1"/>'%tuple(gauge)+'</axis>'*(3+len(h))
    s+=''.join(map(ax,t))+'<workholding location="0 0 0"/>'+'</axis>'*len(t)+'</base></machine>'
    return s
def tip(r,rot):
    p=[gauge[0],gauge[1],gauge[2]-L]; d=[0,0,1]
    for a in reversed([q for q in rot if q[3]=='h']):
        p=turn(p,a[1],a[2],math.radians(r[a[0]])); d=ap(R(a[1],math.radians(r[a[0]])),d)
    p=[p[0]+r['X'],p[1]+r['Y'],p[2]+r['Z']]
    for a in [q for q in rot if q[3]=='t']:
        p=turn(p,a[1],a[2],-math.radians(r[a[0]])); d=ap(R(a[1],-math.radians(r[a[0]])),d)
    return p,d
random.seed(5)
F = os.environ['FIVECHECK']
open('ts.xml','w').write('<setup version="1" units="mm"><work_offset name="G54" X="11" Y="-7" Z="380"/><tool number="1" name="t" length="%g"><cutter tip="flat"><section length="%g" diameter="5"/></cutter></tool></setup>'%(L,L))
def run(x,prog):
    open('tm.xml','w').write(x); open('tp.mpf','w').write(prog)
    o=subprocess.run([F,'-s','ts.xml','--dump-path','tm.xml','tp.mpf'],capture_output=True,text=True)
    rows=o.stdout.split('\n'); h=rows[0].split('\t')
    d={}
    for l in rows[1:]:
        if l:
            v=dict(zip(h,map(float,l.split('\t')))); d[int(v['line'])]=v
    return d,o.stderr
for name,rot in fam.items():
    p='T1 D1 M6\nG54 G17 G71 G90\nTRAORI\nORIAXES\nF1000\n'; want={}
    cur=dict(X=0,Y=0,Z=0); ang={r[0]:0 for r in rot}
    for i in range(40):
        cur={k:round(random.uniform(-50,50),3) for k in 'XYZ'}
        for r in rot: ang[r[0]]=round(random.uniform(-80,80),3)
        p+='G1 '+' '.join('%s%.3f'%kv for kv in {**cur,**ang}.items())+'\n'
        want[6+i]=(dict(cur),dict(ang))
    p+='M30\n'
    d,e=run(xml(name,rot),p)
    w=0
    for ln,(c,a) in want.items():
        t,_=tip(d[ln],rot)
        # program coordinates + G54 is the position of the gauge point's tip at rotary zero
        w=max(w,max(abs(t[i]-(c['XYZ'[i]]+[11,-7,380][i]+gauge[i])) for i in range(3)))
    # CYCLE800: random planes, both DIR
    wc=wd=0; n=0; bad=0
    for i in range(12):
        A,B,C=[round(random.uniform(-40,40),3) for _ in range(3)]
        X0,Y0,Z0=[round(random.uniform(-20,20),3) for _ in range(3)]
        x,y,z=[round(random.uniform(-30,30),3) for _ in range(3)]
        mode,order=random.choice([(57,'XYZ'),(27,'ZYX'),(39,'ZXY'),(30,'YZX'),(45,'XZY'),(54,'YXZ')])
        dr=random.choice([1,-1])
        p='T1 D1 M6\nG54 G17 G71 G90\nG0 X0 Y0 Z0\nCYCLE800(0,"",0,%d,%g,%g,%g,%g,%g,%g,0,0,0,%d)\nG0 X%g Y%g Z%g\nM30\n'%(mode,X0,Y0,Z0,A,B,C,dr,x,y,z)
        d,e=run(xml(name,rot),p)
        if 5 not in d: bad+=1; last=e; continue
        M=[[1,0,0],[0,1,0],[0,0,1]]
        for ax,an in zip(order,(A,B,C)): M=mul(M,R([ax=='X',ax=='Y',ax=='Z'],math.radians(an)))
        t,dd=tip(d[5],rot); q=ap(M,[x,y,z]); q=[q[i]+[X0,Y0,Z0][i]+[11,-7,380][i]+gauge[i] for i in range(3)]
        wc=max(wc,max(abs(t[i]-q[i]) for i in range(3))); wd=max(wd,max(abs(dd[i]-ap(M,[0,0,1])[i]) for i in range(3))); n+=1
        s=[r[0] for r in rot if r[0]!='C'][0]
        assert d[5][s]*dr>=-1e-6
    # TOROT: Z leads along the tool, by an increment and to a coordinate from the workpiece's zero.
    wt=0
    for i in range(4):
        a={r[0]:round(random.uniform(-80,80),3) for r in rot}; c=[round(random.uniform(-50,50),3) for _ in range(3)]
        p='T1 D1 M6\nG54 G17 G71 G90\nTRAORI ORIAXES\nG0 X%g Y%g Z%g %s\nTOROT\nG91 Z25\nG90 Z300\nTOROTOF\nX%g Y%g Z%g\nM30\n'%(*c,' '.join('%s%g'%kv for kv in a.items()),*c)
        d,e=run(xml(name,rot),p); t0,dd=tip(d[4],rot); t1,_=tip(d[6],rot); t2,_=tip(d[7],rot); t3,_=tip(d[9],rot)
        zero=[[11,-7,380][i]+gauge[i] for i in range(3)]
        along=300-sum((t0[i]-zero[i])*dd[i] for i in range(3))
        wt=max([wt]+[abs(t1[i]-t0[i]-25*dd[i]) for i in range(3)]+[abs(t2[i]-t0[i]-along*dd[i]) for i in range(3)]+[abs(t3[i]-t0[i]) for i in range(3)])
    # Angles A2= B2= C2= of the tool's direction.
    x,y,z=[1,0,0],[0,1,0],[0,0,1]
    for word,order in ('ORIEULER',((z,'A'),(x,'B'),(z,'C'))),('ORIRPY',((z,'C'),(y,'B'),(x,'A'))),('ORIRPY2',((x,'A'),(y,'B'),(z,'C'))):
        for i in range(2):
            a={k:round(random.uniform(-40,40),3) for k in 'ABC'}
            d,e=run(xml(name,rot),'T1 D1 M6\nG54 G17 G71 G90\nTRAORI ORIAXES %s\nG0 X1 Y2 Z3 %s1 C1\nG0 %s\nM30\n'%(word,[r[0] for r in rot if r[0]!='C'][0],' '.join('%s2=%g'%kv for kv in a.items())))
            M=[[1,0,0],[0,1,0],[0,0,1]]
            for axis,k in order: M=mul(M,R(axis,math.radians(a[k])))
            if 5 not in d: bad+=1; last=e; continue
            _,dd=tip(d[5],rot); wd=max(wd,max(abs(dd[i]-ap(M,z)[i]) for i in range(3)))
    w=max(w,wt)
    good = w < 1e-6 and wc < 1e-6 and wd < 1e-9 and bad == 0
    print(name + (': as computed' if good else ': TRAORI %g mm, CYCLE800 %g mm, %g, %d refused' % (w, wc, wd, bad)))
# Limits that leave one solution choose it whatever DIR says, and ask nothing of the machine file; then there is none.
for low in -60, -20:
    x=xml('AC table',fam['AC table']).replace(' swivel_axis="A"','').replace('limit_min="-9999" limit_max="9999" rate_max="3600"','limit_min="%d" limit_max="10" rate_max="3600"'%low,1)
    for dr in 1,-1:
        d,e=run(x,'T1 D1 M6\nG54 G17 G71 G90\nG0 C-150\nCYCLE800(0,"",0,57,0,0,0,25,0,0,0,0,0,%d)\nG0 X0\nM30\n'%dr)
        print('A %g C %g'%(d[5]['A'],d[5]['C']) if 5 in d else e.split('\n')[0])
PYTHON
FIVECHECK=$FIVECHECK python3 check.py
