# Writes a small project of VERICUT into this folder: job.VcProject, its machine, a mesh, tools and a program.
cat >block.stl <<'STL'
solid block
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 30 0
vertex 40 0 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 40 0 0
vertex 0 0 20
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 40 0 0
vertex 0 30 0
vertex 0 0 20
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 30 0
vertex 0 0 0
vertex 0 0 20
endloop
endfacet
endsolid
STL
cat >machine.mch <<'XML'
<VcMachine Version="7.1" Unit="millimeter">
<Collision><Between Sub1="off" Sub2="on" Tol="1.5"><Component>X</Component><Component>Base</Component></Between></Collision>
<Component Name="Base" Type="base"><Attach/><Block Length="600" Width="400" Height="50" Mirror="Off"/></Component>
<Component Name="C" Type="rotary"><Attach>Base</Attach><Link Axis="Z" Register="C"/></Component>
<Component Name="Attach" Type="attach"><Attach>C</Attach></Component>
<Component Name="X" Type="linear"><Attach>Base</Attach><Link Axis="X" Register="X" RapidRate="5000">
<TlRecord TlMin="0" TlMax="9" TlIgnore="off"/></Link><Poly Unit="millimeter" Mirror="Off"><File>block.stl</File>
<Position X="0" Y="0" Z="99"/></Poly></Component>
<Component Name="Tool" Type="tool"><Attach>X</Attach></Component>
</VcMachine>
XML
cat >job.VcProject <<'XML'
<VcProject Version="7.1" Unit="millimeter"><Setup Name="a">
<Build><Component Name="Vise" Type="fixture"><Attach>Attach</Attach>
<Poly Unit="millimeter" Mirror="Off"><File>block.stl</File></Poly></Component></Build>
<NCPrograms><NCProgram><File>a.nc</File></NCProgram></NCPrograms>
<GCode><Table Name="Work Offsets"><Row Index="54"><From>Tool</From><To>Vise</To></Row></Table></GCode>
<ToolMan><Library>tools.csv</Library></ToolMan>
<Machine><File>machine.mch</File></Machine></Setup></VcProject>
XML
printf 'number,length,diameter,flute_length\n1,70,10,20\n' >tools.csv
[ -e a.nc ] || printf 'G0 X1\nM2\n' >a.nc
