(The second pass of the slot is programmed as a rapid: it goes through 3 mm of material.)
G21 G90 G94 G61 F1200
T1 M6
S8000 M3
G0 X-60 Y0 A0 C0
G43 H1 Z20
G0 X-60 Y0
G0 Z-9
G1 X60
G0 Z20
G0 X-60
G0 Z-12
G0 X60
G0 Z20
M5
M2
