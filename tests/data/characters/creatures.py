"""Animals on four legs and other creatures of draw.py: the limbs that an animator wants."""
import math

from draw import Drawing


def animal(name, *, spine, girth, legs, leg, head, tail=None, tail_width=(13, 11, 9), neck=None, ears=(),
           nose=None, feet=None, **options):
    """From the side. spine: from the rump to the chest; legs: hip or shoulder, knee, foot, from the
    hind ones on; head: the way from the nape to the nose, with its half widths."""
    d = Drawing(name, "four-legged", "none", **options)
    d.tube(spine, girth)
    for i, path in enumerate(legs):
        end = len(legs) // 2
        d.limb(("hind" if i < end else "fore") + f" leg {i % end + 1}", path, leg)
        if feet:
            d.blob((path[-1][0] + 0.4 * feet[0], path[-1][1]), *feet)
    if neck:
        d.tube(*neck)
    path, widths = head
    d.tube(path, widths)
    d.limbs.append({"name": "head", "tip": path[-1], "base": neck[0][0] if neck else path[0]})
    if tail:
        d.limb("tail", tail, tail_width)
    else:
        d.allow("rump", spine[0])
    for ear in ears:
        d.limb("ear", ear, (13, 11, 5), wanted=False)
    if nose:
        d.limb("nose", *nose, wanted=False)
    return d


def four_legged():
    yield animal("dog", spine=[(-170, 40), (-40, 30), (110, 50)], girth=(62, 56, 66),
                 legs=[[(-190, 20), (-214, -90), (-206, -190)], [(-130, 10), (-136, -90), (-128, -192)],
                       [(80, 10), (78, -90), (74, -192)], [(140, 20), (150, -90), (146, -190)]],
                 leg=(34, 22, 17), feet=(26, 14), head=([(170, 130), (220, 150), (290, 120)], (52, 48, 24)),
                 neck=([(120, 70), (170, 130)], (52, 44)), tail=[(-220, 70), (-266, 120), (-276, 186)],
                 ears=[[(190, 180), (196, 236)]])

    yield animal("horse", spine=[(-150, 60), (0, 44), (120, 70)], girth=(66, 62, 68),
                 legs=[[(-170, 40), (-196, -80), (-186, -220)], [(-110, 20), (-116, -90), (-126, -222)],
                       [(90, 20), (84, -90), (88, -222)], [(146, 40), (168, -80), (160, -218)]],
                 leg=(32, 18, 14), feet=(20, 12), head=([(206, 226), (240, 214), (292, 154)], (36, 36, 22)),
                 neck=([(130, 90), (170, 170), (206, 226)], (56, 42, 36)),
                 tail=[(-206, 90), (-262, 40), (-272, -70)], tail_width=(16, 24, 10),
                 ears=[[(206, 250), (200, 292)]])

    yield animal("cat-arched", spine=[(-110, 0), (0, 60), (110, 10)], girth=(50, 46, 48),
                 legs=[[(-126, -10), (-140, -90), (-142, -180)], [(-84, -10), (-84, -100), (-80, -182)],
                       [(92, -10), (88, -90), (84, -182)], [(132, 0), (142, -90), (146, -180)]],
                 leg=(28, 19, 16), head=([(160, 60), (204, 76)], (54, 50)),
                 neck=([(110, 10), (160, 60)], (44, 44)), tail=[(-140, 20), (-216, 70), (-190, 160), (-236, 226)],
                 tail_width=(17, 16, 15, 12), ears=[[(160, 100), (146, 160)], [(216, 108), (232, 164)]])

    yield animal("elephant", spine=[(-140, 50), (0, 70), (110, 50)], girth=(96, 104, 96),
                 legs=[[(-170, 0), (-176, -110), (-172, -200)], [(-94, -20), (-92, -120), (-90, -202)],
                       [(64, -20), (62, -120), (60, -202)], [(140, 0), (146, -110), (142, -200)]],
                 leg=(46, 40, 36), head=([(276, 90), (316, 0), (304, -120)], (40, 26, 17)),
                 neck=([(180, 100), (240, 112)], (86, 78)),
                 tail=[(-230, 70), (-268, 10), (-270, -60)])

    yield animal("giraffe", spine=[(-120, 20), (-20, 24), (80, 50)], girth=(48, 48, 52),
                 legs=[[(-136, 10), (-148, -110), (-144, -262)], [(-92, 0), (-92, -110), (-94, -264)],
                       [(56, 10), (52, -110), (54, -264)], [(104, 20), (112, -110), (114, -262)]],
                 leg=(24, 14, 12), head=([(176, 286), (206, 290), (256, 266)], (26, 26, 16)),
                 neck=([(90, 70), (134, 180), (176, 286)], (44, 26, 24)),
                 tail=[(-164, 30), (-196, -20), (-200, -80)], ears=[[(172, 300), (162, 336)]])

    yield animal("sheep", spine=[(-120, 40), (0, 52), (110, 40)], girth=(92, 98, 92),
                 legs=[[(-130, -20), (-134, -100), (-132, -176)], [(-70, -30), (-70, -110), (-70, -176)],
                       [(66, -30), (66, -110), (66, -176)], [(124, -20), (130, -100), (128, -176)]],
                 leg=(17, 15, 14), head=([(196, 92), (226, 80), (262, 46)], (44, 44, 28)))

    yield animal("dachshund", spine=[(-210, 10), (0, 0), (190, 20)], girth=(46, 42, 48),
                 legs=[[(-224, -6), (-234, -60), (-230, -110)], [(-170, -10), (-172, -64), (-168, -110)],
                       [(150, -10), (150, -64), (152, -110)], [(206, 0), (214, -60), (212, -110)]],
                 leg=(24, 17, 15), feet=(22, 12), head=([(230, 96), (262, 104), (322, 84)], (36, 36, 17)),
                 neck=([(196, 30), (230, 96)], (38, 32)), tail=[(-250, 24), (-300, 56), (-344, 62)],
                 tail_width=(13, 10, 5))

    yield animal("pig", spine=[(-120, 30), (0, 36), (110, 34)], girth=(98, 104, 94),
                 legs=[[(-116, -30), (-120, -100), (-118, -160)], [(96, -30), (100, -100), (98, -160)]],
                 leg=(34, 30, 26), head=([(170, 60), (206, 56), (252, 40)], (68, 60, 30)),
                 tail=[(-210, 50), (-248, 66), (-252, 100)], tail_width=(9, 8, 6), ears=[[(170, 110), (150, 156)]])

    yield animal("crocodile", spine=[(-110, 0), (20, 6), (130, 0)], girth=(38, 44, 38),
                 legs=[[(-90, -14), (-110, -50), (-96, -92)], [(100, -14), (122, -50), (114, -92)]],
                 leg=(20, 15, 13), feet=(20, 10), head=([(160, 10), (210, 14), (310, -6)], (38, 34, 14)),
                 tail=[(-130, 0), (-220, -20), (-330, -26)], tail_width=(34, 22, 5))

    yield animal("galloping-horse", spine=[(-140, 40), (0, 44), (120, 60)], girth=(58, 54, 60),
                 legs=[[(-164, 20), (-216, -60), (-290, -84)], [(-130, 10), (-150, -84), (-236, -146)],
                       [(116, 26), (196, -10), (224, -96)], [(140, 50), (230, 44), (296, -10)]],
                 leg=(30, 18, 13), head=([(220, 170), (258, 168), (312, 130)], (32, 32, 19)),
                 neck=([(136, 80), (180, 130), (220, 170)], (48, 38, 32)),
                 tail=[(-190, 66), (-258, 104), (-320, 88)], tail_width=(15, 20, 7), ears=[[(222, 194), (216, 232)]])

    yield animal("dinosaur", spine=[(-110, 20), (0, 50), (110, 20)], girth=(66, 86, 64),
                 legs=[[(-90, -10), (-98, -90), (-94, -150)], [(84, -10), (90, -90), (88, -150)]],
                 leg=(38, 32, 28), head=([(226, 196), (256, 200), (296, 184)], (28, 28, 18)),
                 neck=([(120, 40), (180, 120), (226, 196)], (54, 34, 26)),
                 tail=[(-130, 20), (-230, -30), (-330, -70)], tail_width=(52, 30, 6))


def rays(d, centre, count, inner, outer, widths, first=90.0, name="arm", bend=0.0):
    """Limbs that stand around a centre, the first at an angle in degrees."""
    for i in range(count):
        a = math.radians(first + 360 * i / count)
        along, across = (math.cos(a), math.sin(a)), (-math.sin(a), math.cos(a))
        reach = outer * (1 if d.symmetry == "exact" else d.random.uniform(0.92, 1.08))
        at = [(centre[0] + r * along[0] + b * across[0], centre[1] + r * along[1] + b * across[1])
              for r, b in ((inner, 0), ((inner + reach) / 2, bend), (reach, 0))]
        d.limb(f"{name} {i + 1}", at, widths)


def others():
    d = Drawing("octopus", "other", "near", points=300)
    d.blob((0, 120), 110, 122)
    d.limbs.append({"name": "head", "tip": (0, 150), "base": (0, 40)})
    for i, (x, foot, y) in enumerate(((-90, -270, -30), (-68, -206, -170), (-44, -110, -224), (-16, -32, -240),
                                      (16, 44, -238), (44, 122, -220), (68, 212, -160), (90, 268, -24))):
        d.limb(f"arm {i + 1}", [(x, 50), ((x + foot) / 2 + x / 2, (50 + y) / 2 + 10), (foot, y)], (26, 20, 10))
    yield d

    d = Drawing("starfish", "other", "near")
    d.blob((0, 0), 84)
    rays(d, (0, 0), 5, 60, 262, (54, 38, 16))
    yield d

    d = Drawing("star", "other", "exact")
    rays(d, (0, 0), 5, 40, 250, (66, 44, 6))
    d.blob((0, 0), 80)
    yield d

    d = Drawing("fish", "other", "none")
    d.blob((40, 0), 190, 96)
    d.limbs.append({"name": "head", "tip": (190, 0), "base": (110, 0)})
    d.limb("upper tail fin", [(-150, 10), (-220, 56), (-272, 112)], (34, 34, 14))
    d.limb("lower tail fin", [(-150, -10), (-220, -56), (-268, -104)], (34, 34, 14))
    d.limb("back fin", [(20, 80), (-10, 120), (-48, 148)], (44, 34, 8))
    d.limb("belly fin", [(50, -80), (24, -122), (-4, -140)], (24, 20, 8), wanted=False)
    yield d

    d = Drawing("shark", "other", "none")
    d.tube([(-180, -6), (0, 16), (200, 0), (270, -6)], (20, 62, 60, 16))
    d.limbs.append({"name": "head", "tip": (250, -5), "base": (140, 6)})
    d.limb("upper tail fin", [(-180, -6), (-236, 50), (-276, 120)], (22, 20, 7))
    d.limb("lower tail fin", [(-180, -6), (-216, -40), (-240, -76)], (20, 16, 7))
    d.limb("back fin", [(30, 60), (16, 110), (-14, 150)], (44, 26, 6))
    d.limb("breast fin", [(80, -40), (48, -100), (10, -150)], (34, 22, 7))
    yield d

    d = Drawing("bird-flying", "other", "near")
    d.tube([(0, -110), (0, 0), (0, 110)], (26, 52, 40))
    d.limb("head", [(0, 90), (0, 130), (0, 166)], (38, 40, 34))
    d.limb("left wing", [(36, 40), (160, 92), (292, 20)], (56, 50, 12))
    d.limb("right wing", [(-36, 40), (-160, 96), (-288, 26)], (56, 50, 12))
    d.limb("tail", [(0, -100), (0, -150), (2, -204)], (26, 38, 44))
    yield d

    d = Drawing("bird-standing", "other", "none")
    d.tube([(-110, -30), (0, 0), (80, 50)], (44, 86, 72))
    d.limb("head", [(90, 70), (130, 130), (150, 170)], (56, 52, 52))
    d.limb("beak", [(190, 176), (230, 166), (262, 156)], (20, 13, 3), wanted=False)
    d.limb("tail", [(-110, -30), (-190, -50), (-276, -60)], (40, 32, 24))
    d.limb("leg 1", [(-20, -70), (-24, -130), (-26, -204)], (13, 10, 9))
    d.limb("leg 2", [(40, -64), (42, -130), (44, -204)], (13, 10, 9))
    d.blob((-10, -208), 30, 10)
    d.blob((60, -208), 30, 10)
    yield d

    d = Drawing("beetle", "other", "near", points=320)
    d.blob((0, -50), 96, 140)
    d.allow("abdomen", (0, -130))
    d.limb("head", [(0, 90), (0, 120), (0, 150)], (50, 48, 40))
    for i, (y, knee, foot) in enumerate(((60, 100, 150), (-30, -20, -50), (-110, -140, -220))):
        for x in (-1, 1):
            d.limb(f"{'left' if x > 0 else 'right'} leg {i + 1}",
                   [(x * 74, y), (x * 160, knee), (x * 220, foot + d.random.uniform(-10, 10))], (13, 11, 8))
    for x in (-1, 1):
        d.limb("feeler", [(x * 20, 176), (x * 44, 220), (x * 82, 250)], (8, 7, 7), wanted=False)
    yield d

    d = Drawing("spider", "other", "exact", points=380)
    d.blob((0, 0), 92, 100)
    d.allow("head", (0, 50))
    d.allow("abdomen", (0, -50))
    for i, (out, y) in enumerate(((200, 200), (270, 76), (270, -80), (200, -206))):
        for x in (-1, 1):
            d.limb(f"{'left' if x > 0 else 'right'} leg {i + 1}",
                   [(x * 68, y * 0.28), (x * out * 0.72, y * 0.55 + 30), (x * out, y)], (13, 12, 8))
    yield d

    d = Drawing("butterfly", "other", "exact")
    d.tube([(0, -130), (0, 0), (0, 120)], (16, 24, 24))
    for x in (-1, 1):
        side = "left" if x > 0 else "right"
        d.limb(f"{side} upper wing", [(x * 10, 40), (x * 110, 110), (x * 220, 170)], (36, 80, 72))
        d.limb(f"{side} lower wing", [(x * 10, -20), (x * 80, -90), (x * 150, -170)], (30, 60, 56))
        d.limb("feeler", [(x * 10, 130), (x * 30, 190), (x * 62, 240)], (7, 6, 6), wanted=False)
    d.limbs.append({"name": "head", "tip": (0, 120), "base": (0, 60)})
    d.allow("abdomen", (0, -130))
    yield d

    d = Drawing("tree", "other", "none", points=320)
    d.limb("trunk", [(0, -40), (-6, -160), (0, -280)], (38, 36, 46), flat=True)
    d.tube([(0, -60), (6, 40)], (38, 32))
    for i, path in enumerate(([(-6, -10), (-110, 50), (-200, 90)], [(2, 30), (-60, 150), (-112, 262)],
                              [(6, 40), (40, 160), (62, 290)], [(8, 0), (110, 60), (222, 150)],
                              [(8, -50), (110, -40), (206, -10)])):
        d.limb(f"branch {i + 1}", path, (24, 18, 11))
    yield d

    d = Drawing("cactus", "other", "none")
    d.limb("top", [(0, 30), (2, 150), (0, 250)], (56, 56, 50))
    d.limb("foot", [(0, 20), (0, -120), (0, -250)], (56, 58, 58), flat=True)
    d.limb("left arm", [(30, -20), (150, -20), (160, 130)], (34, 34, 30))
    d.limb("right arm", [(-30, 40), (-136, 44), (-144, 170)], (34, 34, 30))
    yield d

    d = Drawing("hand", "other", "none")
    d.body([(40, 96), (-60, 104), (-140, 76), (-170, 62)])
    d.limb("wrist", [(0, -120), (0, -190), (0, -260)], (62, 58, 56), flat=True)
    for name, path, width in (("thumb", [(-70, -50), (-150, 10), (-196, 84)], 30),
                              ("first finger", [(-66, 40), (-84, 140), (-96, 236)], 25),
                              ("middle finger", [(-20, 50), (-22, 160), (-24, 270)], 26),
                              ("ring finger", [(28, 46), (40, 150), (48, 250)], 25),
                              ("little finger", [(74, 30), (100, 110), (120, 184)], 22)):
        d.limb(name, path, (width * 1.05, width, width * 0.85))
    yield d

    d = Drawing("snake", "other", "none", points=300)
    path = [(-290, -60), (-200, 60), (-90, -60), (20, 60), (130, -60), (220, 40), (280, 50)]
    d.tube(path, (8, 22, 28, 30, 30, 30, 34))
    d.limbs += [{"name": "tail", "tip": path[0], "base": (-145, 0)},
                {"name": "head", "tip": path[-1], "base": (200, 22)}]
    yield d

    d = Drawing("snail", "other", "none")
    d.blob((-20, 70), 140, 130)
    d.allow("shell", (-20, 90))
    d.limb("foot", [(0, -60), (-120, -80), (-260, -90)], (40, 30, 10))
    d.limb("head", [(60, -70), (180, -60), (236, 40)], (42, 38, 36))
    for i, way in enumerate(((10, 70), (60, 54))):
        d.limb(f"feeler {i + 1}", [(236, 50), (236 + way[0] / 2, 60 + way[1] / 2 + 10),
                                   (236 + way[0], 60 + way[1] + 20)], (10, 8, 8))
    yield d

    d = Drawing("crab", "other", "near", points=360)
    d.blob((0, 0), 150, 96)
    for x in (-1, 1):
        side = "left" if x > 0 else "right"
        d.limb(f"{side} claw", [(x * 110, 50), (x * 210, 80), (x * 200, 190)], (20, 18, 30))
        for i, (a, b) in enumerate((((236, 0), (296, -60)), ((196, -60), (236, -140)), ((120, -110), (140, -196)))):
            d.limb(f"{side} leg {i + 1}", [(x * (130 - 40 * i), -10 - 30 * i), (x * a[0], a[1]), (x * b[0], b[1])],
                   (16, 13, 8))
        d.limb("eye", [(x * 44, 80), (x * 52, 130)], (10, 15), wanted=False)
    yield d


def all():
    return [*four_legged(), *others()]
