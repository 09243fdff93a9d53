"""The bipeds of draw.py: poses in rough coordinates, bodies around them."""
import numpy as np

from draw import Drawing, mirrored


def biped(name, symmetry, *, pelvis, chest, neck, head, left_arm, left_leg, right_arm=None,
          right_leg=None, arm=(20, 18, 15), leg=(26, 22, 19), hand=None, foot=None, head_shape=None,
          neck_width=18, loose=5.0, **options):
    """Limbs, head and joints; the caller adds the body. Arms: shoulder, elbow, hand; legs: hip,
    knee, foot. What is not said of the right side is the left's mirror image, loosely so where the
    symmetry is not exact. arm, leg: half widths. hand: ("ball", r), ("mitten", r), ("fingers", r, n),
    ("cut",), ("point",); foot: ("aside", length, height), ("ball", r), ("cut",), ("point",).
    head: x, y, rx, ry."""
    if hand and hand[0] == "fingers":
        options["points"] = 330
    d = Drawing(name, "biped", symmetry, **options)

    def other(limb):
        limb = np.array(mirrored(limb), float)
        if symmetry == "exact":
            return limb
        return limb + d.random.normal(0, loose, limb.shape) * np.array([[0.5], [1], [1.5]])

    right_arm = other(left_arm) if right_arm is None else right_arm
    right_leg = other(left_leg) if right_leg is None else right_leg
    x, y, rx, ry = head
    if head_shape != "none":
        d.blob((x, y), rx, ry, bumps=0.03)
    d.tube([chest, neck, (x, y)], [neck_width * 1.3, neck_width, neck_width])
    for side, limbs in (("right", (right_arm, right_leg)), ("left", (left_arm, left_leg))):
        out = -1 if side == "right" else 1
        for limb, widths, end, kind in zip(limbs, (arm, leg), (hand, foot), ("arm", "leg")):
            limb_end(d, [tuple(map(float, p)) for p in limb], widths, end or (None,), out, kind)
        names = ("shoulder", "elbow", "hand", "hip", "knee", "foot")
        for joint, p in zip(names, [*limbs[0], *limbs[1]]):
            d.joints[f"{side}_{joint}"] = tuple(map(float, p))
    centre = {"root": pelvis, "hip": pelvis, "torso": chest, "neck": neck, "head": (x, y)}
    d.joints = {**centre, **d.joints}
    return d


def limb_end(d, path, widths, end, out, kind):
    tip = np.array(path[2])
    way = tip - path[1]
    way /= np.hypot(*way)
    angle = np.degrees(np.arctan2(way[1], way[0]))
    side = np.array([-way[1], way[0]]) * out
    if end[0] == "aside":
        d.tube([*path[:2], tip - (0.45 * out * end[1], 0)], widths)
        d.blob(tip, end[1], end[2], turn=-5 * out)
        return
    if end[0] == "point":
        d.tube([*path, tip + way * 3 * widths[-1]], [*widths, 2])
        return
    d.tube(path, widths, flat=end[0] == "cut")
    if end[0] == "ball":
        d.blob(tip, end[1], bumps=0.08)
    elif end[0] == "mitten":
        d.blob(tip + way * 0.2 * end[1], end[1] * 1.25, end[1], turn=angle)
        thumb = tip - way * 0.2 * end[1]
        d.tube([thumb, thumb + (way * 0.7 - side * 1.5) * end[1]], [0.42 * end[1], 0.3 * end[1]])
    elif end[0] == "fingers":
        d.blob(tip, end[1])
        for turn in np.linspace(-16, 16, end[2]) * end[2]:
            c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
            to = tip + np.array([c * way[0] - s * way[1], s * way[0] + c * way[1]]) * end[1] * 2.6
            d.tube([tip, to], [0.36 * end[1], 0.32 * end[1]])
            d.allow("finger" if kind == "arm" else "toe", tuple(to))


def heads():
    """Big heads on small bodies."""
    d = biped("girl-in-dress", "near", pelvis=(0, -85), chest=(0, 55), neck=(0, 92), head=(0, 185, 112, 100),
              left_arm=[(38, 55), (102, 48), (168, 44)], left_leg=[(34, -88), (38, -190), (58, -270)],
              arm=(19, 17, 15), leg=(18, 16, 15), hand=("ball", 22), foot=("aside", 38, 19))
    d.body([(78, 28), (50, 44), (-10, 62), (-90, 100), (-150, 132), (-160, 128)])
    for x in (-1, 1):
        d.tube([(x * 95, 215), (x * 150, 190), (x * 165, 120)], [26, 24, 12])
        d.allow("bunch", (x * 165, 120))
    yield d

    d = biped("boy-arms-out", "exact", pelvis=(0, -95), chest=(0, 60), neck=(0, 95), head=(0, 190, 105, 98),
              left_arm=[(62, 58), (138, 62), (212, 60)], left_leg=[(32, -98), (40, -190), (62, -280)],
              arm=(21, 19, 17), leg=(29, 26, 23), hand=("ball", 25), foot=("aside", 42, 20))
    d.body([(84, 50), (50, 68), (-40, 62), (-110, 62), (-128, 50)])
    yield d

    d = biped("boy-waving", "none", pelvis=(4, -80), chest=(0, 62), neck=(-3, 100), head=(-8, 198, 100, 104),
              left_arm=[(54, 62), (128, 92), (160, 190)], right_arm=[(-52, 58), (-92, -10), (-112, -78)],
              left_leg=[(34, -84), (44, -180), (64, -272)], right_leg=[(-28, -84), (-34, -178), (-62, -276)],
              arm=(19, 17, 14), leg=(27, 23, 20), hand=("fingers", 15, 4), foot=("aside", 40, 19))
    d.body([(86, 40), (55, 58), (-30, 54), (-95, 58), (-118, 44)])
    d.spikes((-8, 198), 98, 35, 150, 6, 32)
    d.allow("hair", (-12, 318))
    yield d

    d = biped("toddler", "near", pelvis=(0, -128), chest=(0, 10), neck=(0, 42), head=(0, 160, 138, 128),
              left_arm=[(60, 2), (104, -40), (146, -84)], left_leg=[(34, -132), (40, -198), (48, -262)],
              arm=(26, 24, 20), leg=(30, 28, 26), hand=None, foot=("ball", 33), neck_width=30)
    d.body([(46, 40), (0, 66), (-80, 76), (-140, 68), (-162, 46)])
    yield d

    d = biped("egg-man", "near", pelvis=(0, -110), chest=(0, 35), neck=(0, 110), head=(0, 188, 88, 92),
              left_arm=[(96, 20), (160, 58), (222, 100)], left_leg=[(44, -120), (52, -196), (60, -268)],
              arm=(11, 10, 9), leg=(13, 12, 11), hand=("fingers", 12, 3), foot=("aside", 36, 15),
              neck_width=60)
    d.blob((0, -15), 112, 142)
    yield d

    d = biped("princess", "exact", pelvis=(0, -60), chest=(0, 85), neck=(0, 124), head=(0, 195, 66, 70),
              left_arm=[(40, 84), (84, 20), (116, -48)], left_leg=[(36, -64), (42, -170), (46, -262)],
              arm=(16, 14, 11), leg=(16, 15, 14), hand=("mitten", 16), foot=("aside", 28, 14))
    d.body([(108, 28), (80, 46), (28, 34), (0, 60), (-90, 118), (-190, 162), (-212, 158)])
    for x, y in ((0, 318), (-46, 300), (46, 300)):
        d.poly([(x - 26, 245), (x, y), (x + 26, 245)])
        d.allow("crown", (x, y))
    yield d


def grown_ups():
    """Longer legs, trousers, skirts."""
    d = biped("man-in-trousers", "near", pelvis=(0, -28), chest=(0, 112), neck=(0, 150), head=(0, 218, 56, 64),
              left_arm=[(62, 118), (110, 40), (146, -36)], left_leg=[(36, -32), (50, -150), (62, -262)],
              arm=(21, 19, 15), leg=(38, 35, 34), hand=("mitten", 18), foot=("aside", 46, 17))
    d.body([(142, 42), (118, 72), (40, 60), (-20, 66), (-52, 62)])
    yield d

    d = biped("woman-in-skirt", "near", pelvis=(0, -10), chest=(0, 110), neck=(0, 150), head=(0, 212, 58, 62),
              left_arm=[(44, 112), (106, 72), (164, 30)], left_leg=[(34, -14), (36, -140), (40, -258)],
              arm=(15, 14, 12), leg=(19, 17, 14), hand=("ball", 18), foot=("aside", 30, 13))
    d.body([(140, 26), (115, 50), (40, 36), (10, 54), (-70, 96), (-90, 98)], sharp=True)
    d.body([(262, 50), (240, 68), (190, 78), (130, 82), (112, 70)])
    yield d

    d = biped("arms-raised", "near", pelvis=(0, -50), chest=(0, 80), neck=(0, 116), head=(0, 180, 62, 60),
              left_arm=[(48, 84), (92, 158), (140, 236)], left_leg=[(30, -54), (50, -160), (72, -262)],
              arm=(18, 16, 14), leg=(24, 21, 18), hand=("fingers", 16, 5), foot=("aside", 34, 16))
    d.body([(108, 34), (80, 52), (10, 46), (-50, 52), (-78, 44)])
    yield d

    d = biped("strong-man", "exact", pelvis=(0, -70), chest=(0, 82), neck=(0, 150), head=(0, 206, 48, 52),
              left_arm=[(98, 106), (196, 100), (186, 214)], left_leg=[(36, -74), (54, -170), (66, -258)],
              arm=(38, 34, 24), leg=(40, 32, 24), hand=("ball", 30), foot=("aside", 44, 20), neck_width=26)
    d.body([(140, 60), (108, 108), (40, 92), (-40, 62), (-92, 62)])
    yield d

    d = biped("hands-on-hips", "near", pelvis=(0, -40), chest=(0, 98), neck=(0, 134), head=(0, 202, 64, 68),
              left_arm=[(54, 104), (168, 62), (100, -16)], left_leg=[(30, -54), (44, -156), (58, -262)],
              arm=(15, 14, 12), leg=(24, 21, 19), hand=("ball", 16), foot=("aside", 36, 16), loose=3.0)
    d.body([(128, 40), (104, 58), (40, 42), (-20, 46), (-50, 52), (-76, 46)])
    yield d

    d = biped("long-coat", "near", pelvis=(0, -40), chest=(0, 100), neck=(0, 140), head=(0, 205, 52, 62),
              left_arm=[(66, 104), (104, 24), (128, -56)], left_leg=[(32, -44), (34, -160), (44, -268)],
              arm=(26, 25, 24), leg=(24, 23, 22), hand=("cut",), foot=("aside", 40, 18))
    d.body([(134, 42), (108, 76), (20, 66), (-70, 88), (-165, 112), (-176, 110)])
    yield d

    d = biped("thin-legs", "near", pelvis=(0, 20), chest=(0, 116), neck=(0, 152), head=(0, 218, 70, 64),
              left_arm=[(52, 112), (116, 112), (178, 104)], left_leg=[(34, 16), (36, -126), (38, -270)],
              arm=(10, 9, 8), leg=(11, 10, 9), hand=("ball", 16), foot=("aside", 32, 12))
    d.body([(142, 36), (110, 58), (50, 62), (0, 60), (-14, 50)])
    yield d

    d = biped("legs-apart", "none", pelvis=(-6, -40), chest=(2, 92), neck=(6, 128), head=(12, 194, 66, 64),
              left_arm=[(56, 96), (126, 62), (150, -14)], right_arm=[(-52, 90), (-126, 108), (-196, 132)],
              left_leg=[(30, -48), (86, -142), (146, -232)], right_leg=[(-38, -46), (-80, -146), (-116, -252)],
              arm=(19, 17, 14), leg=(27, 24, 20), hand=("mitten", 17), foot=("aside", 36, 17))
    d.body([(1, 120, 38), (2, 94, 60), (-2, 20, 52), (-6, -44, 58), (-6, -72, 46)])
    yield d


def on_the_move():
    """Poses without symmetry."""
    d = biped("runner", "none", pelvis=(-18, -28), chest=(20, 92), neck=(38, 128), head=(62, 192, 60, 64),
              left_arm=[(62, 84), (126, 22), (196, 74)], right_arm=[(-20, 98), (-98, 70), (-112, -20)],
              left_leg=[(12, -34), (112, -86), (108, -210)], right_leg=[(-44, -38), (-86, -142), (-198, -170)],
              arm=(18, 16, 13), leg=(27, 23, 18), hand=("ball", 18), foot=("ball", 23))
    d.body([(30, 116, 36), (22, 92, 54), (4, 30, 48), (-16, -30, 50), (-22, -54, 42)])
    yield d

    d = biped("kicker", "none", pelvis=(-20, -30), chest=(-36, 92), neck=(-40, 128), head=(-46, 192, 62, 60),
              left_arm=[(8, 92), (76, 60), (136, 102)], right_arm=[(-86, 90), (-150, 44), (-206, -4)],
              left_leg=[(10, -38), (106, -62), (206, -40)], right_leg=[(-44, -40), (-60, -150), (-48, -264)],
              arm=(17, 15, 13), leg=(27, 23, 19), hand=("ball", 17), foot=("ball", 25))
    d.body([(-38, 118, 36), (-36, 92, 54), (-28, 30, 48), (-20, -32, 52), (-20, -60, 44)])
    yield d

    d = biped("dancer", "none", pelvis=(0, -40), chest=(-14, 84), neck=(-20, 120), head=(-32, 184, 58, 62),
              left_arm=[(30, 90), (92, 160), (60, 238)], right_arm=[(-58, 84), (-136, 50), (-190, -10)],
              left_leg=[(28, -46), (118, -110), (64, -196)], right_leg=[(-26, -48), (-34, -160), (-46, -272)],
              arm=(16, 14, 11), leg=(24, 20, 14), hand=None, foot=("point",))
    d.body([(-16, 110, 32), (-14, 86, 48), (-6, 30, 38), (0, -10, 52), (2, -80, 80), (2, -92, 76)])
    yield d

    d = biped("walker", "none", pelvis=(0, -40), chest=(4, 92), neck=(6, 130), head=(14, 200, 72, 70),
              left_arm=[(48, 90), (104, 28), (128, -50)], right_arm=[(-44, 92), (-122, 42), (-150, -40)],
              left_leg=[(26, -46), (66, -146), (88, -254)], right_leg=[(-28, -46), (-38, -150), (-84, -250)],
              arm=(18, 16, 14), leg=(26, 23, 20), hand=("ball", 19), foot=("ball", 25))
    d.body([(120, 38), (92, 54), (20, 48), (-45, 54), (-70, 46)])
    yield d

    d = biped("sitting-jump", "near", pelvis=(0, -60), chest=(0, 70), neck=(0, 108), head=(0, 182, 80, 76),
              left_arm=[(54, 74), (132, 112), (204, 168)], left_leg=[(36, -68), (136, -106), (120, -222)],
              arm=(18, 17, 15), leg=(27, 25, 21), hand=("mitten", 18), foot=("aside", 34, 18))
    d.body([(98, 38), (72, 58), (0, 54), (-60, 58), (-88, 48)])
    yield d

    d = biped("leaning", "none", pelvis=(-30, -50), chest=(18, 76), neck=(36, 110), head=(66, 172, 66, 64),
              left_arm=[(62, 58), (120, 6), (176, -48)], right_arm=[(-30, 90), (-104, 118), (-170, 158)],
              left_leg=[(-2, -60), (18, -160), (36, -262)], right_leg=[(-58, -54), (-72, -156), (-92, -258)],
              arm=(18, 16, 13), leg=(25, 22, 18), hand=("point",), foot=("aside", 34, 17))
    d.body([(30, 98, 36), (18, 78, 54), (-8, 10, 48), (-30, -52, 52), (-36, -78, 42)])
    yield d

    d = biped("thinker", "none", pelvis=(0, -50), chest=(-4, 84), neck=(-6, 120), head=(-10, 190, 76, 72),
              left_arm=[(52, 86), (148, 50), (118, 138)], right_arm=[(-54, 80), (-92, -2), (-98, -90)],
              left_leg=[(32, -54), (42, -160), (60, -264)], right_leg=[(-32, -54), (-38, -158), (-60, -262)],
              arm=(18, 17, 14), leg=(27, 24, 22), hand=("ball", 19), foot=("aside", 38, 18))
    d.body([(110, 40), (84, 60), (10, 54), (-55, 60), (-80, 50)])
    yield d


def costumes():
    """Monsters, robots, snowmen, animals that stand upright."""
    d = biped("robot", "exact", pelvis=(0, -60), chest=(0, 84), neck=(0, 138), head=(0, 200, 60, 50),
              left_arm=[(88, 96), (164, 96), (164, -10)], left_leg=[(44, -70), (44, -166), (44, -256)],
              arm=(19, 19, 19), leg=(24, 24, 24), hand=("cut",), foot=None, head_shape="none", neck_width=16)
    d.poly([(-68, 152), (68, 152), (68, 252), (-68, 252)])
    d.poly([(-92, 122), (92, 122), (92, -96), (-92, -96)])
    for x in (-1, 1):
        d.poly([(x * 14, -246), (x * 86, -246), (x * 86, -284), (x * 14, -284)])
        d.limb("antenna", [(x * 40, 245), (x * 52, 300)], (6, 6), wanted=False)
    yield d

    d = biped("robot-round", "near", pelvis=(0, -90), chest=(0, 46), neck=(0, 112), head=(0, 180, 84, 68),
              left_arm=[(104, 46), (168, 12), (208, -48)], left_leg=[(48, -100), (50, -176), (52, -250)],
              arm=(15, 15, 15), leg=(20, 20, 20), hand=("fingers", 18, 2), foot=("aside", 44, 24),
              neck_width=30)
    d.body([(98, 84), (60, 116), (-60, 116), (-112, 88)])
    d.limb("aerial", [(0, 240), (4, 300)], (6, 9), wanted=False)
    yield d

    d = Drawing("snowman", "biped", "near", tremor=1.2)
    d.blob((0, -180), 128, 116)
    d.blob((0, 4), 98, 92)
    d.blob((0, 148), 72, 68)
    d.poly([(-52, 190), (52, 190), (46, 288), (-46, 288)])
    d.poly([(-84, 186), (84, 186), (84, 206), (-84, 206)])
    arms = {"left": [(78, 24), (148, 52), (220, 96)], "right": [(-80, 22), (-152, 66), (-216, 88)]}
    d.joints = {"root": (0, -150), "hip": (0, -150), "torso": (0, 20), "neck": (0, 88), "head": (0, 145)}
    for side, path in arms.items():
        d.tube(path, (9, 8, 6))
        d.joints.update(zip((f"{side}_shoulder", f"{side}_elbow", f"{side}_hand"), path))
        end = np.array(path[2])
        for way in ((0.3, 1), (1, 0.1)):
            to = end + np.array(way) * (26 if side == "left" else -26, 26)
            d.tube([end, to], (6, 5))
            d.allow("twig", tuple(to))
    d.allow("hat", (0, 275))
    for x in (-1, 1):
        d.allow("brim", (x * 76, 196))
    d.allow("bottom", (0, -180))
    yield d

    d = biped("blob-monster", "near", pelvis=(0, -120), chest=(0, 30), neck=(0, 100), head=(0, 170, 110, 90),
              left_arm=[(120, 20), (182, 60), (230, 128)], left_leg=[(64, -140), (72, -200), (80, -256)],
              arm=(26, 22, 18), leg=(40, 36, 34), hand=("fingers", 20, 3), foot=("ball", 40), neck_width=100)
    d.blob((0, -10), 150, 160)
    for x in (-1, 1):
        d.tube([(x * 60, 240), (x * 88, 290), (x * 118, 312)], (20, 14, 5))
        d.allow("horn", (x * 118, 308))
    yield d

    d = biped("tall-monster", "none", pelvis=(0, -110), chest=(-4, 70), neck=(-8, 130), head=(-12, 208, 76, 86),
              left_arm=[(70, 74), (166, 76), (214, -6)], right_arm=[(-78, 70), (-160, 96), (-196, 182)],
              left_leg=[(38, -122), (54, -192), (66, -266)], right_leg=[(-38, -122), (-46, -196), (-66, -268)],
              arm=(24, 22, 20), leg=(30, 28, 26), hand=("fingers", 19, 4), foot=("aside", 46, 20), neck_width=62)
    d.body([(120, 66), (70, 84), (-20, 76), (-110, 84), (-145, 66)])
    d.tube([(70, -100), (128, -120), (176, -186)], (22, 14, 4))
    d.allow("tail", (172, -178))
    yield d

    d = biped("ghost-with-feet", "near", pelvis=(0, -120), chest=(0, 50), neck=(0, 110), head=(0, 185, 92, 92),
              left_arm=[(92, 60), (142, 104), (184, 156)], left_leg=[(42, -140), (46, -204), (56, -264)],
              arm=(22, 18, 13), leg=(17, 16, 15), hand=None, foot=("aside", 34, 17), neck_width=84)
    d.body([(190, 88), (110, 96), (0, 104), (-120, 122), (-190, 136), (-200, 130)])
    yield d

    d = biped("bear-upright", "near", pelvis=(0, -110), chest=(0, 50), neck=(0, 104), head=(0, 182, 92, 82),
              left_arm=[(86, 58), (140, 10), (180, -50)], left_leg=[(56, -122), (76, -196), (98, -260)],
              arm=(36, 33, 27), leg=(48, 44, 36), hand=("ball", 32), foot=("aside", 54, 28), neck_width=60)
    d.body([(100, 66), (50, 98), (-50, 116), (-130, 100), (-160, 70)])
    for x in (-1, 1):
        d.blob((x * 72, 250), 32)
        d.allow("ear", (x * 78, 258))
    yield d

    d = biped("cat-upright", "near", pelvis=(0, -90), chest=(0, 46), neck=(0, 88), head=(0, 160, 92, 74),
              left_arm=[(48, 48), (94, -4), (132, -62)], left_leg=[(32, -98), (42, -182), (50, -268)],
              arm=(19, 17, 15), leg=(24, 20, 18), hand=("ball", 20), foot=("aside", 34, 18))
    d.body([(80, 40), (46, 54), (-30, 56), (-90, 62), (-124, 46)])
    for x in (-1, 1):
        d.poly([(x * 24, 220), (x * 74, 300), (x * 90, 180)])
        d.allow("ear", (x * 70, 280))
    d.tube([(46, -96), (126, -130), (190, -92), (206, -10)], (15, 13, 12, 10))
    d.allow("tail", (206, -10))
    yield d

    d = biped("rabbit-upright", "exact", pelvis=(0, -120), chest=(0, 6), neck=(0, 46), head=(0, 108, 76, 66),
              left_arm=[(52, 8), (108, 30), (164, 44)], left_leg=[(36, -128), (44, -200), (70, -276)],
              arm=(18, 17, 15), leg=(28, 25, 22), hand=("ball", 20), foot=("aside", 54, 19), points=300)
    d.body([(40, 42), (6, 58), (-80, 66), (-130, 62), (-158, 44)])
    for x in (-1, 1):
        d.tube([(x * 34, 150), (x * 46, 226), (x * 58, 292)], (20, 26, 14))
        d.allow("ear", (x * 58, 290))
    yield d

    d = biped("penguin-like", "near", pelvis=(0, -150), chest=(0, 60), neck=(0, 122), head=(0, 190, 74, 76),
              left_arm=[(104, 56), (152, -6), (176, -72)], left_leg=[(52, -170), (58, -216), (72, -262)],
              arm=(24, 22, 13), leg=(20, 19, 18), hand=None, foot=("aside", 50, 17), neck_width=66)
    d.body([(140, 74), (80, 104), (-40, 126), (-150, 104), (-206, 60)])
    yield d

    d = biped("wizard", "near", pelvis=(0, -90), chest=(0, 50), neck=(0, 84), head=(0, 128, 58, 54),
              left_arm=[(48, 52), (112, 42), (170, 38)], left_leg=[(40, -94), (42, -190), (52, -272)],
              arm=(18, 26, 34), leg=(18, 17, 16), hand=("cut",), foot=("aside", 34, 16))
    d.body([(72, 34), (48, 54), (-60, 78), (-200, 122), (-214, 120)])
    d.poly([(-92, 150), (92, 152), (64, 172), (24, 300), (-30, 338), (-62, 170)])
    d.allow("hat", (-14, 280))
    d.allow("brim", (-86, 154))
    d.allow("brim", (86, 154))
    yield d

    d = biped("fox-with-tail", "none", pelvis=(0, -80), chest=(0, 54), neck=(0, 96), head=(4, 170, 84, 64),
              left_arm=[(46, 56), (110, 84), (170, 62)], right_arm=[(-46, 56), (-126, 22), (-114, -62)],
              left_leg=[(30, -88), (42, -178), (54, -268)], right_leg=[(-32, -88), (-36, -180), (-54, -266)],
              arm=(17, 15, 13), leg=(23, 20, 17), hand=("ball", 17), foot=("aside", 34, 15))
    d.body([(88, 36), (54, 50), (-30, 50), (-80, 56), (-112, 42)])
    for x in (-1, 1):
        d.poly([(4 + x * 22, 215), (4 + x * 78, 296), (4 + x * 84, 185)])
        d.allow("ear", (4 + x * 74, 280))
    d.tube([(44, -80), (124, -116), (186, -60), (236, 0)], (13, 34, 42, 5))
    d.allow("tail", (226, -14))
    yield d

    d = biped("scribbled-figure", "none", pelvis=(10, -60), chest=(2, 70), neck=(0, 110), head=(-6, 186, 84, 78),
              left_arm=[(54, 74), (138, 66), (216, 82)], right_arm=[(-52, 70), (-130, 52), (-196, 20)],
              left_leg=[(40, -70), (50, -160), (88, -244)], right_leg=[(-24, -66), (-54, -164), (-68, -262)],
              arm=(16, 20, 12), leg=(20, 26, 16), hand=("fingers", 14, 5), foot=("ball", 22), tremor=2.0)
    d.body([(2, 100, 36), (2, 70, 60), (4, 0, 64), (10, -62, 58), (10, -90, 40)])
    d.spikes((-6, 186), 80, 20, 165, 8, 26)
    for x, y in ((-76, 236), (-8, 285), (56, 264)):
        d.allow("hair", (x, y))
    yield d

    d = biped("alien", "exact", pelvis=(0, -60), chest=(0, 58), neck=(0, 92), head=(0, 190, 108, 88),
              left_arm=[(34, 58), (92, 8), (112, -84)], left_leg=[(22, -66), (60, -160), (48, -268)],
              arm=(11, 10, 9), leg=(14, 12, 11), hand=("fingers", 11, 3), foot=("aside", 30, 12), neck_width=12)
    d.body([(84, 22), (58, 38), (0, 32), (-60, 36), (-82, 28)])
    yield d

    d = biped("ballerina", "exact", pelvis=(0, -10), chest=(0, 100), neck=(0, 138), head=(0, 200, 54, 58),
              left_arm=[(36, 104), (120, 130), (86, 232)], left_leg=[(22, -16), (36, -138), (48, -262)],
              arm=(14, 13, 10), leg=(20, 17, 12), hand=None, foot=("point",), points=300)
    d.body([(128, 24), (104, 40), (40, 30), (12, 60), (-34, 148), (-52, 140), (-60, 44)], sharp=True)
    d.blob((0, 268), 24)
    d.allow("bun", (0, 272))
    for x in (-1, 1):
        d.allow("tutu", (x * 140, -42))
    yield d


def joined(d):
    """Thin limbs begin beside the spine, and hang on it."""
    for centre, limb in (("torso", "shoulder"), ("hip", "hip")):
        for side in ("right", "left"):
            d.tube([d.joints[centre], d.joints[f"{side}_{limb}"]], [8, 8])


def plain():
    """Stick figures and tadpoles, and what children dress them in."""
    thin = {"arm": (8, 7, 7), "leg": (9, 8, 8), "neck_width": 9}
    d = biped("stick-figure", "near", pelvis=(0, -60), chest=(0, 88), neck=(0, 124), head=(0, 196, 72, 70),
              left_arm=[(24, 86), (90, 70), (156, 48)], left_leg=[(14, -76), (54, -166), (98, -258)], loose=6.0,
              **thin)
    d.tube([(0, 120), (3, 10), (0, -64)], [9, 10, 9])
    joined(d)
    yield d

    d = biped("stick-figure-running", "none", pelvis=(-14, -50), chest=(14, 90), neck=(24, 128),
              head=(40, 200, 68, 70), left_arm=[(36, 80), (104, 60), (150, 140)],
              right_arm=[(-8, 80), (-80, 48), (-132, -26)], left_leg=[(4, -62), (88, -116), (80, -240)],
              right_leg=[(-24, -66), (-70, -150), (-176, -208)], foot=("aside", 24, 10), **thin)
    d.tube([(22, 122), (6, 20), (-14, -54)], [9, 10, 9])
    joined(d)
    yield d

    d = biped("triangle-dress", "near", pelvis=(0, -70), chest=(0, 80), neck=(0, 112), head=(0, 176, 68, 64),
              left_arm=[(22, 72), (90, 66), (160, 76)], left_leg=[(34, -84), (40, -180), (46, -268)],
              hand=("fingers", 9, 3), foot=("aside", 26, 10), **thin)
    d.poly([(-8, 120), (8, 120), (112, -126), (-112, -122)])
    joined(d)
    for x in (-1, 1):
        d.limb("plait", [(x * 62, 190), (x * 100, 150), (x * 104, 92)], (13, 12, 8), wanted=False)
    yield d

    d = Drawing("tadpole", "biped", "near", tremor=1.8)
    d.blob((0, 80), 150, 140)
    d.joints = {"root": (0, -34), "hip": (0, -34), "torso": (0, 50)}
    d.allow("head", (0, 80))
    for side, x in (("right", -1), ("left", 1)):
        arm = [(x * 140, 50), (x * 196, 46 - 5 * x), (x * 256, 42)]
        leg = [(x * 48, -48), (x * 54, -160), (x * 58, -264)]
        d.tube(arm, (14, 13, 12))
        d.tube(leg, (16, 15, 15))
        d.blob((x * 70, -272), 36, 17)
        d.joints.update(zip((f"{side}_shoulder", f"{side}_elbow", f"{side}_hand"), arm))
        d.joints.update(zip((f"{side}_hip", f"{side}_knee", f"{side}_foot"), leg))
    yield d

    d = biped("superhero", "none", pelvis=(0, -50), chest=(0, 88), neck=(0, 132), head=(4, 196, 56, 62),
              left_arm=[(74, 96), (128, 166), (176, 240)], right_arm=[(-74, 94), (-164, 74), (-158, -24)],
              left_leg=[(36, -56), (52, -158), (64, -262)], right_leg=[(-34, -56), (-50, -160), (-74, -262)],
              arm=(25, 21, 17), leg=(32, 27, 22), hand=("ball", 24), foot=("aside", 40, 18), neck_width=22)
    d.body([(126, 50), (92, 88), (20, 66), (-50, 62), (-80, 54)])
    d.poly([(60, 110), (92, 90), (206, -96), (168, -120), (124, -70), (60, -20)])
    d.allow("cape", (188, -102))
    yield d

    d = biped("clown", "near", pelvis=(0, -110), chest=(0, 34), neck=(0, 74), head=(0, 138, 72, 68),
              left_arm=[(70, 40), (140, 10), (206, -30)], left_leg=[(42, -116), (54, -186), (84, -262)],
              arm=(32, 29, 24), leg=(38, 36, 33), hand=("mitten", 22), foot=("aside", 56, 24))
    d.body([(62, 42), (30, 80), (-50, 96), (-120, 84), (-150, 66)])
    d.poly([(-54, 190), (54, 190), (10, 316), (-6, 316)])
    d.allow("hat", (2, 305))
    for x in (-1, 1):
        d.blob((x * 82, 150), 34)
        d.allow("hair", (x * 88, 150))
    yield d


def all():
    return [*heads(), *grown_ups(), *on_the_move(), *costumes(), *plain()]
