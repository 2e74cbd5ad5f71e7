"""The B head and C table machine: bed -> X -> Z -> B with the spindle, bed -> Y -> C with the table.

Machine coordinates at the zero pose: x to the right, y away from the operator, z up from the table's surface. C turns
about x = y = 0, B about the line x = 0, z = 720; the gauge line is at z = 500.
"""
from parts import (SLOT_14, ball_screw, bolts, cover, finned_drum, foot, grid_pockets, guide_pair, lay_y_up,
                   lay_z_front, motor, round_table_radial, screw_circle, spindle_nose, trucks)
from solids import (arc, box, prism, prism_x, prism_y, rectangle, revolve, ring, rounded, tube, union)

NAME = 'b-head-c-table'
PIVOT = 720  # height of the B axis


def bed():
    """The bed, T-shaped in plan: in front the Y guideways of the table; behind them, and higher, the X guideways of the
    column."""
    front = prism_x(rounded([(-640, -600), (540, -600), (540, -300), (-600, -300), (-640, -340)], 12), -340, 340, 8)
    flank = prism_x(rectangle(-620, 500, -590, -330, 15), 320, 356, 4,
                    [(p, 20) for p in grid_pockets(-620, 500, -590, -330, 4, 1, 40, 28)], 3)
    rear = prism_y(rounded([(-860, -600), (860, -600), (860, -140), (-860, -140)], 25), 520, 1060, 10,
                   [(p, 30) for x in (-860, 350) for p in grid_pockets(x, x + 510, -590, -150, 2, 2, 30, 20)], 3)
    y_guides = lay_y_up(guide_pair(1000, 45, 166, 440)).move(0, -20, -300)
    x_guides = guide_pair(1600, 45, 200, 320).move(0, 790, -140)
    y_screw = lay_y_up(ball_screw(980, 16)).move(0, -40, -264) + motor(110, 240).face('-y').move(0, -600, -250) \
        + box(-70, 70, -610, -560, -310, -190, 5, 10)
    x_screw = ball_screw(1620, 16).move(0, 790, -108) + motor(110, 240).face('+x').move(838, 790, -85) \
        + box(800, 840, 725, 855, -150, -20, 5, 10)
    chute = prism_y([(345, -470), (620, -560), (620, -420), (600, -420), (600, -530), (345, -440)], -620, 510)
    feet = union(foot(70).move(x, y, -600) for x, y in ((-280, -540), (280, -540), (-280, 200), (280, 200), (-780, 600),
                                                        (780, 600), (-780, 980), (780, 980)))
    return front + (flank + chute).both('x') + rear + y_guides + x_guides + y_screw + x_screw + feet


def column():
    """The X axis: the column, with the Z guideways on its front."""
    outline = rounded([(600, -70), (1010, -70), (1010, 60), (930, 500), (900, 1480), (600, 1480)],
                      [15, 15, 60, 300, 25, 20])
    windows = [rounded([(660, 20), (920, 20), (860, 420), (660, 420)], 40, 4)] \
        + grid_pockets(620, 890, 440, 1460, 1, 3, 40, 30)
    right = prism_x(outline, 20, 270, 10, [(p, 40) for p in windows], 4)
    web = prism_x(rectangle(615, 880, -20, 1460), -40, 40)
    base = prism(rectangle(-290, 290, 575, 1015, 25), -77, -30, 6) \
        + bolts([(x, y, -30) for x in (-279, 279) for y in range(600, 1000, 75)], 14, '+z')
    runs = trucks((-190, 190), 45, 320).move(0, 790, -140)
    guides = lay_z_front(guide_pair(1040, 45, 130, 360)).move(0, 600, 535)
    screw = ball_screw(1440, 20).turn('y', -90).move(0, 585, 745)
    top = box(-110, 110, 560, 800, 1475, 1520, 6, 12) + motor(130, 300).move(0, 680, 1520)
    ladder = union(revolve([(9, -22), (9, 22)], 8).face('+y').move(-282, 960, z) for z in range(200, 460, 60))
    cabinet = box(274, 350, 650, 860, 900, 1300, 6, 10) + cover(670, 840, 930, 1270, 5, 3, 4, 6).face('+x').move(350, 0)
    return right.both('x') + web + base + runs + guides + screw + top + ladder + cabinet


def slide():
    """The Z axis: a deep slide, with the B bearing in its front."""
    outline = rounded([(-230, 590), (230, 590), (230, 1010), (-230, 1010)], 30)
    plate = prism_y(outline, 500, 540, 6)
    nose = prism_y(arc((0, PIVOT), 150, 180, 360, 32) + rounded([(150, 750), (150, 930), (-150, 930), (-150, 750)],
                                                              [0, 40, 40, 0]), 165, 510, 6)
    rib = prism_x([(180, 900), (505, 900), (505, 1000), (440, 1000)], -12, 12)
    bearing = tube(104, 146, 0, 16, 2, 48).face('-y').move(0, 168, PIVOT)
    runs = lay_z_front(trucks((-140, 0, 140), 45, 360)).move(0, 600, 800)
    fin = prism_x(rounded([(300, 640), (505, 600), (505, 980), (300, 860)], 20), 145, 165, 3,
                  [(rounded([(340, 670), (480, 650), (480, 930), (340, 840)], 15), 10)], 2)
    lids = cover(-90, 90, 190, 420, 5, 3, 4, 6).move(0, 0, 929)
    drive = finned_drum(96, 0, 130, 5).face('+y').move(0, 360, 800)
    hydraulics = box(-60, 60, 430, 500, 935, 1000, 4, 8) \
        + union(revolve([(9, 0), (9, 18), (14, 18), (14, 30), (9, 34)], 12).move(x, 465, 1000)
                for x in (-36, -12, 12, 36))
    return plate + nose + rib.move(-90) + rib.move(90) + runs + fin.both('x') + lids + drive + hydraulics + bearing


def head():
    """The B axis: a disc on the bearing, and across it the motor spindle."""
    disc = revolve([(140, 102), (144, 106), (144, 140), (138, 146), (102, 146), (102, 160)], 48).face('+y')
    outline = arc((0, PIVOT), 122, -10, 190, 28) + rounded([(-118, 660), (-84, 600), (-84, 580), (84, 580), (84, 600),
                                                            (118, 660)], [0, 30, 12, 12, 30, 0])
    block = prism_y(outline, -96, 104, 8)
    nose = spindle_nose(62, 92, 36, 48).move(0, 0, 500)
    front = revolve([(92, 0), (92, 8), (88, 12), (50, 12), (46, 18), (20, 18)], 48) + screw_circle(76, 8, 8, 12)
    top = revolve([(70, 836), (70, 852), (64, 858), (24, 858), (24, 880), (18, 886)], 40) + screw_circle(56, 8, 6, 858)
    pads = prism_x(rectangle(-70, 80, 640, 800, 12), 112, 124, 2)
    hoses = revolve([(8, 540), (8, 600)], 12)
    rim = screw_circle(132, 12, 7).face('-y').move(0, 103, PIVOT)
    return disc.move(0, 0, PIVOT) + rim + block + nose + front.face('-y').move(0, -96, PIVOT) + top + pads.both('x') \
        + (hoses.move(70, -50) + hoses.move(70, 50)).both('x')


def saddle():
    """The Y axis: the slide below the table, with the C drive inside."""
    body = prism(rectangle(-290, 290, -265, 265, 30), -236, -150, 8)
    house = ring([(172, -152), (240, -152), (240, -124), (232, -116), (172, -116)], 48)
    lip = tube(172, 225, -130, -104, 2, 48) + screw_circle(198, 12, 8, -104)
    runs = lay_y_up(trucks((-180, 180), 45, 440)).move(0, 0, -300)
    lids = cover(-240, 240, -225, -165, 5, 5, 2, 6)
    skirts = prism_y([(-350, -250), (-290, -235), (-290, -225), (-350, -238)], -285, 285)
    nut = box(-55, 55, -80, 80, -249, -230, 3)
    return body + house + lip + runs + nut + lids.face('-y').move(0, -265).both('y') + skirts.both('x')


def table():
    """The C table: diameter 560 mm, eight radial T-slots and a central bore."""
    slots, depth = round_table_radial(280, 8, SLOT_14, 45, 10)
    disc = tube(45, 280, -70, -depth, 1.5, 64)
    hub = ring([(45, -128), (167, -128), (170, -125), (170, -69), (45, -69)], 64)
    grooves = tube(276, 283, -54, -42, 0, 64)
    centre = tube(25, 46, -40, -1, 0, 40)
    return slots + disc + hub + grooves + centre


BODIES = [bed, column, slide, head, saddle, table]
