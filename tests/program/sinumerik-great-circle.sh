# ORIVECT on tables, heads and nutating axes: the tip goes straight, the tool turns in the plane of its two directions, and
# between two rows the rotary axes are where the great circle has them, to what a piece may be beside its chord.
need python3
cat >check.py <<'PYTHON'
import math, os, random, subprocess
# Rodrigues: v turned by a about the unit k
def turn_vector(k,a,v):
    c,s=math.cos(a),math.sin(a); d=(1-c)*(k[0]*v[0]+k[1]*v[1]+k[2]*v[2])
    return [c*v[0]+s*(k[1]*v[2]-k[2]*v[1])+d*k[0],c*v[1]+s*(k[2]*v[0]-k[0]*v[2])+d*k[1],c*v[2]+s*(k[0]*v[1]-k[1]*v[0])+d*k[2]]
def turn(p,axis,loc,a): return [x+y for x,y in zip(turn_vector(axis,a,[q-l for q,l in zip(p,loc)]),loc)]
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
# in the order in which they turn the tool as the workpiece sees it: (letter, axis, location, sign)
def turns(rot):
    return [(q[0],q[1],q[2],1) for q in reversed(rot) if q[3]=='h']+[(q[0],q[1],q[2],-1) for q in rot if q[3]=='t']
def tip(r,rot):
    p=[gauge[0],gauge[1],gauge[2]-L]; last=[q for q in turns(rot) if q[3]>0]
    for a in last: p=turn(p,a[1],a[2],math.radians(r[a[0]]))
    p=[p[0]+r['X'],p[1]+r['Y'],p[2]+r['Z']]
    for a in turns(rot)[len(last):]: p=turn(p,a[1],a[2],-math.radians(r[a[0]]))
    return p
random.seed(7)
F = os.environ['FIVECHECK']
open('ts.xml','w').write('<setup version="1" units="mm"><work_offset name="G54" X="11" Y="-7" Z="380"/><tool number="1" name="t" length="%g"><cutter tip="flat"><section length="%g" diameter="5"/></cutter></tool></setup>'%(L,L))
def direction(r,rot):
    d=[0,0,1]
    for a in turns(rot): d=turn_vector(a[1],a[3]*math.radians(r[a[0]]),d)
    return d
dot=lambda a,b: sum(x*y for x,y in zip(a,b))
cross=lambda a,b: [a[1]*b[2]-a[2]*b[1],a[2]*b[0]-a[0]*b[2],a[0]*b[1]-a[1]*b[0]]
norm=lambda a: math.sqrt(dot(a,a))
unit=lambda a: [x/norm(a) for x in a]
def on_circle(d0,d1,s):
    n=unit(cross(d0,d1)); w=math.atan2(norm(cross(d0,d1)),dot(d0,d1))
    return turn_vector(n,w*s,d0)
def solve(r,rot,d):
    # Newton's method on two angles. The second axis turns what the first one has turned.
    (first,k,_,si),(second,l,_,sj)=turns(rot); a,b=math.radians(r[first]),math.radians(r[second])
    for _ in range(30):
        once=turn_vector(k,si*a,[0,0,1]); now=turn_vector(l,sj*b,once)
        f=[x-y for x,y in zip(now,d)]
        J=[[si*x for x in turn_vector(l,sj*b,cross(k,once))],[sj*x for x in cross(l,now)]]
        p,q,t=dot(J[0],J[0]),dot(J[0],J[1]),dot(J[1],J[1]); u,v=dot(J[0],f),dot(J[1],f); det=p*t-q*q
        e=(t*u-q*v)/det,(p*v-q*u)/det; a-=e[0]; b-=e[1]
        if max(map(abs,e))<1e-12: return {first:a,second:b}
    raise ArithmeticError('Newton')
for name,rot in fam.items():
    tilt=[q[0] for q in rot if q[0]!='C'][0]
    open('tm.xml','w').write(xml(name,rot))
    worst={'tip':0,'plane':0,'beside':0}; bad=0; rows_seen=0; last=''
    for case in range(12):
        c0={k:round(random.uniform(-50,50),3) for k in 'XYZ'}; c1={k:round(random.uniform(-50,50),3) for k in 'XYZ'}
        a0={tilt:round(random.uniform(20,60),3),'C':round(random.uniform(-60,60),3)}
        a1={tilt:a0[tilt]+round(random.uniform(-12,12),3),'C':a0['C']+round(random.uniform(-25,25),3)}
        words=lambda d: ' '.join('%s%.3f'%kv for kv in d.items())
        d1=direction(a1,rot)
        end='A3=%.12f B3=%.12f C3=%.12f'%tuple(d1) if case%2 else words(a1)
        p='T1 D1 M6\nG54 G17 G71 G90\nTRAORI\nORIWKS ORIAXES\nF1000\nG1 %s %s\nORIVECT\n%s %s\nM30\n'%(words(c0),words(a0),words(c1),end)
        open('tp.mpf','w').write(p)
        o=subprocess.run([F,'-s','ts.xml','--dump-path','tm.xml','tp.mpf'],capture_output=True,text=True)
        rows=[l.split('\t') for l in o.stdout.split('\n') if l]; h=rows[0]
        rows=[dict(zip(h,map(float,r))) for r in rows[1:]]
        start=[r for r in rows if r['line']==6]; rows=[r for r in rows if r['line']==8]
        if not rows: bad+=1; last=o.stderr; continue
        rows=[start[-1]]+rows
        d0=direction(a0,rot); P0,P1=[[c['XYZ'[i]]+[11,-7,380][i]+gauge[i] for i in range(3)] for c in (c0,c1)]
        length=math.dist(P0,P1); before=None
        for r in rows:
            t,d=tip(r,rot),direction(r,rot); s=math.dist(P0,t)/length; rows_seen+=1
            worst['tip']=max(worst['tip'],math.dist(t,[x+s*(y-x) for x,y in zip(P0,P1)]))
            worst['plane']=max(worst['plane'],math.dist(d,on_circle(d0,d1,s)))
            if before:
                mid={k:(r[k]+before[0][k])/2 for k in (tilt,'C')}
                e=solve(mid,rot,on_circle(d0,d1,(s+before[1])/2))
                worst['beside']=max(worst['beside'],max(abs(e[k]-math.radians(mid[k])) for k in mid))
            before=(r,s)
        worst['tip']=max(worst['tip'],math.dist(tip(rows[-1],rot),P1))
    # Rows inside of a piece lie on its chord, which may be beside the circle.
    good=worst['tip']<1e-6 and worst['plane']<5e-5 and worst['beside']<2.1e-5 and not bad
    print(name+(': as computed' if good else ': %s, %d refused, %s'%(worst,bad,last)))
# From a pole, where the tool lies along C: a parameter says what the control does.
open('tp.mpf','w').write('T1 D1 M6\nG54 G17 G71 G90\nTRAORI\nORIWKS ORIVECT\nF1000\nG1 X1 A3=0.1 B3=0.2 C3=1\nM30\n')
for answer in '',' orientation_pole="axes"':
    open('tm.xml','w').write(xml('AC table',fam['AC table']).replace(' swivel_axis',answer+' swivel_axis'))
    o=subprocess.run([F,'-s','ts.xml','--dump-path','tm.xml','tp.mpf'],capture_output=True,text=True)
    print([l for l in o.stderr.split('\n') if 'error' in l][0] if o.returncode else 'read')
PYTHON
FIVECHECK=$FIVECHECK python3 check.py
