"""The C/B head machine: a travelling portal over a fixed table, bed -> Y -> X -> Z -> C -> B with the spindle.

Machine coordinates at the zero pose: x across the table, y along it, z up from its surface. C turns about x = y = 0,
B about the line x = 0, z = 1050; the gauge line is at z = 800.
"""
from parts import (SLOT_18, ball_screw, bolts, cover, finned_drum, foot, grid_pockets, guide_pair, lay_x_front,
                   lay_y_up, lay_z_back, long_table, motor, rail, screw_circle, spindle_nose, truck, trucks)
from solids import (arc, box, circle, prism, prism_x, prism_y, rectangle, revolve, rounded, stack, tube, union)

NAME = 'cb-head'
PIVOT = 1050  # height of the B axis


def bed():
    """Two side beds with the Y guideways, the bed of the table between them, and the ties."""
    outline = rounded([(-760, -380), (1500, -380), (1500, -130), (-760, -130)], 20)
    side = prism_x(outline, 880, 1060, 8, [(p, 35) for p in grid_pockets(-760, 1500, -380, -130, 7, 1, 45, 25)], 4)
    guide = lay_y_up(rail(2200, 55, 220)).move(970, 370, -130)
    rack = box(1064, 1084, -720, 1460, -170, -130, 2) \
        + bolts([(1084, y, -150) for y in range(-690, 1450, 260)], 10, '+x')
    shelf = box(1050, 1074, -740, 1480, -215, -170, 3)
    middle = prism_x(rounded([(-1000, -380), (1000, -380), (1000, -150), (960, -122), (-960, -122), (-1000, -150)], 12),
                     -420, 420, 10)
    flank = prism_x(rectangle(-980, 980, -370, -160, 12), 400, 440, 4,
                    [(p, 20) for p in grid_pockets(-980, 980, -370, -160, 6, 1, 40, 25)], 3)
    ties = union(box(-900, 900, y - 90, y + 90, -380, -300, 8) for y in (-600, 100, 800))
    trough = prism_y([(430, -300), (890, -300), (890, -270), (620, -290), (470, -250), (430, -250)], -740, 1480)
    feet = union(foot(60).move(x, y, -380) for x in (-970, 970) for y in (-660, 10, 700, 1390)) \
        + union(foot(60).move(0, y, -380) for y in (-900, 900))
    return (side + guide + rack + shelf + flank + trough).both('x') + middle + ties + feet


def table():
    """The fixed table, with nine T-slots along y."""
    slab = long_table(1900, 1000, 122, [100 * i for i in range(-4, 5)], SLOT_18).turn('z', 90)
    eyes = union(revolve([(16, 0), (16, 12), (26, 12), (26, 40), (20, 46)], 16).face(d).move(x, y, -45)
                 for x in (-350, 350) for d, y in (('-y', -948), ('+y', 948)))
    return slab + eyes + bolts([(500, y, -30) for y in range(-900, 901, 300)], 12, '+x').both('x')


def portal():
    """The Y axis: two legs and the beam, with the X guideways on its front."""
    leg = rounded([(40, -46), (700, -46), (700, 160), (560, 420), (540, 1780), (215, 1780), (215, 420), (40, 160)],
                  [20, 20, 60, 200, 20, 20, 200, 60])
    openings = [rounded([(150, 120), (590, 120), (480, 390), (270, 390)], 40, 4)] \
        + grid_pockets(215, 540, 420, 1780, 1, 4, 45, 30)
    side = prism_x(leg, 900, 1040, 8, [(p, 40) for p in openings], 4)
    base = box(880, 1062, 40, 700, -52, 0, 6, 20) + bolts([(1052, y, 0) for y in range(70, 700, 150)], 14, '+z')
    runs = union(lay_y_up(truck(55)).move(970, y, -130) for y in (150, 590))
    pinion = motor(130, 280).face('+z').move(1000, 370, 0) + box(1040, 1110, 290, 450, -110, 30, 6, 12) \
        + revolve([(60, 0), (66, 4), (66, 40), (60, 44)], 32).face('+x').move(1100, 370, -40)
    beam = prism_y(rectangle(-910, 910, 1350, 1770, 25), 240, 540, 8,
                   [(p, 40) for p in grid_pockets(-880, 880, 1420, 1700, 8, 1, 40, 22)], 4)
    ribs = union(prism_y(p, 530, 556, 3) for p in grid_pockets(-880, 880, 1360, 1760, 7, 1, 20, 16))
    guides = lay_x_front(guide_pair(1560, 45, 195, 320)).move(0, 240, 1560)
    screw = lay_x_front(ball_screw(1500, 24)).move(0, 236, 1560)
    drive = motor(120, 260).face('+x').move(800, 330, 1850) + box(740, 802, 260, 400, 1765, 1920, 6, 10)
    chain = box(-720, 300, 430, 530, 1768, 1786, 2) \
        + union(box(x, x + 72, 435, 525, 1786, 1830, 4) for x in range(-700, 250, 84))
    cabinet = box(920, 1030, 300, 500, 1780, 2000, 5, 10) \
        + cover(-80, 80, 1810, 1970, 4, 3, 3, 6).face('+x').move(1030, 400)
    return (side + base + runs + pinion).both('x') + beam + ribs + guides + screw + drive + chain + cabinet


def carriage():
    """The X axis: the plate with the guideways of the ram."""
    plate = prism_y(rectangle(-220, 220, 1320, 1900, 30), 152, 190, 6)
    x_trucks = lay_x_front(trucks((-150, 150), 45, 320)).move(0, 240, 1560)
    z_trucks = lay_z_back(trucks((-150, 150), 35, 180)).move(0, 120, 1600)
    cheek = prism_x(rounded([(154, 1340), (154, 1880), (60, 1800), (60, 1430)], [0, 0, 40, 40], 4), 170, 205, 4,
                    [(rounded([(135, 1420), (135, 1800), (82, 1760), (82, 1470)], 12), 14)], 2)
    top = box(-100, 100, 150, 300, 1895, 1945, 6, 12) + motor(130, 300).move(0, 215, 1945)
    nut = box(-70, 70, 186, 222, 1525, 1595, 5)
    weight = revolve([(22, 1400), (26, 1404), (26, 1860), (22, 1864), (12, 1864), (12, 1960)], 24)
    return plate + x_trucks + z_trucks + cheek.both('x') + top + nut + weight.move(246, 168).both('x') \
        + box(190, 250, 150, 190, 1440, 1480, 4).both('x') + box(190, 250, 150, 190, 1780, 1820, 4).both('x') \
        + bolts([(x, 152, z) for x in (-140, 140) for z in range(1380, 1860, 150)], 12, '-y')


def ram():
    """The Z axis: a square ram, with the C drive in its lower end."""
    square = rectangle(-120, 120, -120, 120, 16)
    body = prism(square, 1330, 2520, 6)
    n = len(square)
    collar = stack([(circle(138, n, (0, 0), -135), 1302), (circle(142, n, (0, 0), -135), 1308),
                    (circle(142, n, (0, 0), -135), 1336), (square, 1366), (square, 1380)])
    seal = tube(96, 140, 1301, 1312, 1, 48)
    guides = lay_z_back(guide_pair(1140, 35, 163, 180)).move(0, 120, 1940)
    lids = union(cover(-104, 104, z, z + 350, 5, 3, 3, 6) for z in (1390, 1760, 2130)).face('-y').move(0, -120)
    sides = union(cover(-95, 70, z, z + 350, 5, 2, 4, 6) for z in (1390, 1760, 2130)).face('+x').move(120, 0)
    top = prism(rectangle(-90, 90, -90, 90, 14), 2518, 2560, 5) + finned_drum(70, 2560, 2660, 5) \
        + revolve([(62, 2658), (62, 2674), (54, 2682)], 32)
    return body + collar + seal + guides + lids + sides + sides.mirror('x') + top


def fork():
    """The C axis: a flange below the ram, and the two cheeks that hold the B axis."""
    flange = revolve([(132, 1268), (136, 1272), (136, 1294), (130, 1299)], 48)
    crown = prism(rounded([(-118, -196), (118, -196), (118, 196), (-118, 196)], 60, 6), 1222, 1272, 6)
    outline = arc((0, PIVOT), 98, 180, 360, 24) + rounded([(98, PIVOT + 60), (112, 1225), (112, 1268), (-112, 1268),
                                                           (-112, 1225), (-98, PIVOT + 60)], [0, 30, 8, 8, 30, 0])
    cheek = prism_y(outline, -194, -126, 5, [(circle(84, 40, (0, PIVOT)), 8)], 2)
    cap = revolve([(78, 0), (78, 22), (72, 28), (40, 28), (36, 34), (36, 46), (32, 50)], 40) \
        + screw_circle(66, 8, 8, 27)
    side = cheek + cap.face('-y').move(0, -187, PIVOT) \
        + cover(-70, 70, 1160, 1250, 4, 3, 2, 6).face('-y').move(0, -194)
    clamp = screw_circle(126, 8, 8).face('-z').move(0, 0, 1268)
    return flange + crown + side.both('y') + clamp


def head():
    """The B axis: the motor spindle, which swings between the cheeks."""
    nose = spindle_nose(62, 92, 36, 48).move(0, 0, 800)
    housing = revolve([(80, 886), (86, 892), (86, 930), (98, 950), (98, 1130), (92, 1142), (70, 1150), (66, 1164),
                       (30, 1168)], 48)
    block = prism_y(rounded([(-96, 960), (96, 960), (96, 1120), (-96, 1120)], 40, 5), -112, 112, 6)
    journal = revolve([(88, 108), (88, 116), (82, 118), (82, 124), (78, 125)], 48)
    journals = (journal.face('+y') + screw_circle(70, 8, 8).face('+y').move(0, 112, 0)).move(0, 0, PIVOT).both('y')
    plate = (cover(-56, 56, 985, 1100, 5, 2, 3, 6).face('+x').move(95, 0)).both('x')
    drum = tube(90, 104, 900, 914, 2, 48) + screw_circle(91, 8, 6).face('-z').move(0, 0, 892)
    hose = revolve([(8, 840), (8, 900)], 12)
    return nose + housing + block + journals + plate + drum + union(hose.move(x, y) for x, y in
                                                                    ((76, 40), (-76, 40), (76, -40), (-76, -40)))


BODIES = [bed, table, portal, carriage, ram, fork, head]
