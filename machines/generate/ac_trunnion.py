"""The A/C trunnion machine: bed -> Y -> X -> Z with the spindle, bed -> A -> C with the table.

Machine coordinates at the zero pose: x to the right, y away from the operator, z up. The A axis is the line y = 0,
z = 120; C turns about x = y = 0; the gauge line is at z = 520.
"""
from parts import (SLOT_14, ball_screw, bolts, cover, finned_drum, foot, grid_pockets, guide_pair, lay_x_front,
                   lay_y_up, lay_z_back, motor, rail, round_table_parallel, screw_circle, spindle_nose, truck, trucks)
from solids import (arc, around, box, circle, prism, prism_x, prism_y, rectangle, revolve, ring, rounded, stack, tube,
                    union)

NAME = 'ac-trunnion'
PIVOT = 120  # height of the A axis


def bed():
    """The bed, one casting: a trough with floor, rear wall and two side walls; the Y guideways are on the walls."""
    gutters = [(rectangle(-560, 560, y, y + 110, 40), 60) for y in (-400, 320)]
    floor = prism(rectangle(-760, 760, -450, 800, 30), -440, -230, 8, gutters, 4)
    outline = rounded([(-450, -440), (800, -440), (800, 400), (-120, 400), (-300, 120), (-450, 60)],
                      [20, 20, 20, 60, 120, 40], 4)
    windows = [rounded([(-370, -200), (-190, -200), (-190, 170), (-220, 150), (-300, 10), (-370, -10)], 25, 3)] \
        + grid_pockets(-190, 780, -240, 350, 4, 2, 40, 30)
    wall = prism_x(outline, 600, 760, 10, [(w, 45) for w in windows], 4)
    guide = lay_y_up(rail(860, 45, 105)).move(680, 350, 400)
    rim = bolts([(760, y, 375) for y in range(-80, 780, 210)], 12, '+x')
    screw = lay_y_up(ball_screw(800, 16)).move(608, 350, 425)
    rear = rounded([(-610, -440), (610, -440), (610, 300), (420, 300), (300, 0), (-300, 0), (-420, 300), (-610, 300)],
                   [0, 0, 0, 40, 60, 60, 40, 0], 4)
    front = prism_x(rounded([(-450, -232), (-400, -232), (-400, -120), (-450, -150)], 8), -600, 600, 2)
    feet = union(foot(70).move(x, y, -440) for x in (-680, 0, 680) for y in (-380, 180, 720))
    return floor + (wall + guide + rim + screw).both('x') + prism_y(rear, 770, 800, 4) + front + feet


def pedestal():
    """The right A bearing: a pedestal with the bearing housing on top."""
    outline = arc((0, PIVOT), 130, -12, 192, 24) + rounded([(-150, -130), (-190, -235), (190, -235), (150, -130)],
                                                           [30, 0, 0, 30], 3)
    body = prism_x(outline, 292, 392, 4, [(circle(77, 40, (0, PIVOT)), None)])
    rib = prism(rectangle(292, 440, -14, 14), -235, -20, 2)
    base = box(296, 470, -200, 200, -235, -195, 5, 20)
    return body + base + rib.move(0, -90) + rib.move(0, 90) \
        + screw_circle(116, 12, 5, 0, 15).face('-x').move(292, 0, PIVOT) \
        + bolts([(455, y, -195) for y in (-180, -130, 130, 180)], 16, '+z')


def bearing_right():
    """The idle side of the cradle, with the rotary union for the clamping hydraulics."""
    lid = revolve([(118, 0), (120, 3), (120, 22), (112, 30), (60, 34), (60, 62), (54, 68), (24, 70), (24, 110),
                   (20, 114)])
    hoses = around(revolve([(9, 0), (9, 26), (14, 26), (14, 40), (8, 44)], 12).move(42, 0, 66), 4, 45)
    return pedestal() + (lid + hoses + screw_circle(95, 8, 8, 31)).face('+x').move(388, 0, PIVOT)


def bearing_left():
    """The driven side of the cradle: worm gear box and motor."""
    outline = rounded([(-150, -60), (150, -60), (150, 200), (60, 262), (-60, 262), (-150, 200)], 25, 3)
    gear = prism_x(outline, -470, -388, 6)
    worm = revolve([(58, -164), (62, -160), (62, 150), (58, 154)], 40).face('+y').move(-430, 0, -10)
    lid = revolve([(105, 0), (108, 3), (108, 14), (104, 18), (40, 18), (36, 40), (30, 42)])
    return pedestal().mirror('x') + gear + worm + motor(116, 230).face('-y').move(-430, -158, -10) \
        + (lid + screw_circle(94, 8, 8, 18)).face('-x').move(-470, 0, PIVOT + 10) \
        + cover(-120, 120, -28, 28, 4, 3, 2, 5).face('-x').move(-470, 0, -20)


def arm():
    """The right arm of the cradle, with its journal."""
    outline = rounded([(-91, 95), (-150, -10), (-150, -62), (150, -62), (150, -10), (91, 95)],
                      [0, 40, 30, 30, 40, 0], 4) \
        + arc((0, PIVOT), 92, -8, 188, 24)
    dent = rounded([(-105, -20), (105, -20), (62, 62), (-62, 62)], 18, 3)
    side = prism_x(outline, 228, 284, 6, [(dent, 20)], 3)
    journal = revolve([(100, 283), (100, 288), (86, 289), (75, 289), (75, 330), (72, 333)], 40)
    hub = revolve([(84, 0), (84, 6), (80, 8), (30, 8), (26, 12)], 40) + screw_circle(66, 8, 8, 8)
    gusset = prism_y([(205, -22), (229, -22), (229, 44), (222, 44), (205, 10)], -150, -134, 1)
    ribs = union(prism_y([(90, -62), (130, -110), (140, -110), (250, -62)], y - 8, y + 8, 1) for y in (-60, 0, 60))
    return side + journal.face('+x').move(0, 0, PIVOT) + hub.face('-x').move(229, 0, PIVOT) + gusset.both('y') + ribs


def cradle():
    """The cradle: two arms on journals, the floor between them, and below it the C drive."""
    floor = prism(rectangle(-270, 270, -150, 150, 20), -62, -20, 5)
    lip = tube(121.5, 182, -25, 18, 2, 64) + screw_circle(154, 12, 5, 18)
    plate = prism_y(rectangle(-180, 180, -56, -26, 8), -154, -149, 1.5) \
        + bolts([(x, -154, z) for x in range(-165, 180, 110) for z in (-49, -33)], 6, '-y')
    drive = finned_drum(118, -132, -60, 4) + revolve([(84, -152), (90, -150), (90, -130)], 40) \
        + revolve([(50, -168), (54, -166), (54, -150)], 32) + screw_circle(76, 8, 6).face('-z').move(0, 0, -152)
    plug = box(-34, 34, -142, -100, -118, -74, 4) \
        + revolve([(13, 0), (13, 14), (10, 20)], 16).face('-y').move(0, -142, -96)
    return arm().both('x') + floor + lip + plate + plate.turn('z', 180) + drive + plug


def table():
    """The C table: diameter 400 mm, six T-slots and a central bore; its hub turns in the ring of the cradle."""
    slots, depth = round_table_parallel(200, [-157.5, -94.5, -31.5, 31.5, 94.5, 157.5], SLOT_14, 16, 12)
    disc = tube(16, 200, -55, -depth, 1, 64)
    groove = ring([(196, -44), (201.5, -44), (203, -42.5), (203, -35.5), (201.5, -34), (196, -34)], 64)
    hub = ring([(16, -98), (117, -98), (120, -95), (120, -54), (16, -54)], 64)
    return (slots + disc + groove + hub).move(0, 0, 80)


def bridge():
    """The Y axis: a portal with its beam behind the spindle and its feet on the guideways of the walls."""
    front = rectangle(-640, 640, 540, 860, 30)
    recess = [(p, 35) for p in grid_pockets(-560, 560, 590, 810, 6, 1, 50, 18)]
    beam = prism_y(front, 215, 470, 8, recess, 3)
    ribs = union(prism_y(p, 462, 500, 4) for p in grid_pockets(-640, 640, 540, 860, 5, 1, 24, 20))
    outline = rounded([(190, 463), (520, 463), (520, 520), (476, 600), (476, 860), (215, 860), (215, 540), (190, 520)],
                      [12, 12, 40, 40, 10, 10, 10, 12], 4)
    side = prism_x(outline, 640, 750, 8, [(rectangle(250, 440, 600, 820, 30), 25)], 3)
    base = box(596, 752, 190, 520, 463, 500, 5, 12) + bolts([(742, y, 500) for y in range(205, 520, 100)], 12, '+z')
    runs = union(lay_y_up(truck(45)).move(680, y, 400) for y in (270, 440))
    guides = lay_x_front(guide_pair(1160, 35, 100, 200)).move(0, 215, 700)
    screw = lay_x_front(ball_screw(1080, 16)).move(0, 208, 700)
    drive = motor(90, 200).face('+x').move(570, 255, 912) + box(520, 572, 205, 305, 850, 962, 5, 8)
    chain = box(-560, 300, 300, 400, 858, 876, 2) \
        + union(box(x, x + 34, 305, 395, 876, 912, 3) for x in range(-540, 280, 40))
    return beam + ribs + (side + base + runs).both('x') + guides + screw + drive + chain


def carriage():
    """The X axis: the plate between the guideways of the portal and those of the ram."""
    plate = prism_y(rectangle(-190, 190, 560, 1060, 25), 132, 166, 5)
    x_trucks = lay_x_front(trucks((-120, 120), 35, 200)).move(0, 215, 700)
    z_trucks = lay_z_back(trucks((-130, 0, 130), 25, 150)).move(0, 100, 830)
    cheek = prism_x(rounded([(134, 580), (134, 1040), (60, 980), (60, 650)], [0, 0, 30, 30], 5), 150, 180, 4,
                    [(rounded([(118, 640), (118, 960), (78, 930), (78, 680)], 10, 4), 12)], 2)
    strips = bolts([(x, 132, z) for x in (-130, 130) for z in range(610, 1050, 140)], 10, '-y')
    top = box(-90, 90, 130, 260, 1055, 1100, 6, 12)
    drive = motor(110, 260).move(0, 185, 1100)
    x_nut = box(-60, 60, 160, 190, 672, 728, 4)
    chain = box(200, 260, 100, 178, 760, 1000, 6, 10) \
        + bolts([(260, y, z) for y in (115, 163) for z in (780, 980)], 6, '+x')
    return plate + x_trucks + z_trucks + cheek.both('x') + strips + top + drive + x_nut + chain \
        + box(170, 206, 145, 166, 800, 960, 3)


def head():
    """The Z axis: the ram with the motor spindle."""
    square = rounded([(-100, -100), (100, -100), (100, 100), (-100, 100)], 14, 4)
    ram = prism(square, 640, 1430, 6)
    n = len(square)
    cone = stack([(circle(92, n, (0, 0), -135), 596), (circle(94, n, (0, 0), -135), 606), (square, 645),
                  (square, 660)])
    nose = spindle_nose(66, 96, 38, 56).move(0, 0, 520)
    collar = tube(70, 96, 590, 604, 2, 56) + screw_circle(84, 8, 8).face('-z').move(0, 0, 590)
    guides = lay_z_back(guide_pair(760, 25, 126, 150)).move(0, 100, 1030)
    lids = cover(-86, 86, 690, 930, 5, 3, 3, 6).face('-y').move(0, -100) \
        + cover(-86, 86, 950, 1410, 5, 3, 4, 6).face('-y').move(0, -100)
    sides = cover(-80, 70, 690, 1410, 5, 2, 5, 6).face('+x').move(100, 0)
    top = revolve([(88, -2), (92, 2), (92, 20)], 40) + finned_drum(88, 20, 120, 5) \
        + revolve([(80, 118), (80, 142), (70, 150), (22, 150), (22, 190), (16, 196)], 40) + screw_circle(60, 8, 8, 150)
    lines = union(revolve([(7, 560), (7, 660)], 12).move(x, -88, 0) for x in (-60, 60))
    return ram + cone + nose + collar + guides + lids + sides + sides.mirror('x') + top.move(0, 0, 1430) + lines


BODIES = [bed, bearing_left, bearing_right, bridge, carriage, head, cradle, table]
