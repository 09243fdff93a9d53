#!/usr/bin/python3
"""Draws the characters of this folder: draw.py [FOLDER]. Needs numpy and shapely.

Each is made of tubes and blobs around a pose, united, smoothed and traced with a hand's tremor; where
a person would place the joints is known from the pose. What is drawn is in bipeds.py and
creatures.py; this file knows how. The viewer's right is the character's left, y is up.
"""
import json
import math
import sys
from pathlib import Path

import numpy as np
from shapely.geometry import LineString, MultiPoint, Polygon
from shapely.ops import unary_union

SIZE = 600  # the longer side


def curve(points, steps=12):
    """Catmull-Rom through rows of coordinates."""
    rows = np.asarray(points, float)
    if len(rows) == 2:
        t = np.linspace(0, 1, steps)[:, None]
        return rows[0] * (1 - t) + rows[1] * t
    ends = np.vstack([2 * rows[0] - rows[1], rows, 2 * rows[-1] - rows[-2]])
    out = []
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:]):
        for t in np.linspace(0, 1, steps, endpoint=False):
            out.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                              (3 * b - a - 3 * c + d) * t ** 3))
    return np.array(out + [rows[-1]])


def mirrored(points):
    return [(-x, y) for x, y in points]


class Drawing:
    """Shapes and what is known of them. symmetry: "exact", "near" or "none"."""

    def __init__(self, name, kind, symmetry, points=240, tremor=None):
        self.name, self.kind, self.symmetry = name, kind, symmetry
        self.random = np.random.default_rng(sum(ord(c) * 131 ** (i % 7) for i, c in enumerate(name)))
        self.count = points + int(self.random.integers(-60, 60))
        self.tremor = tremor or self.random.uniform(0.8, 1.8)
        self.shapes = []
        self.joints, self.limbs, self.allowed = {}, [], []

    def tube(self, path, widths, flat=False):
        """Around a curved path; half widths at even steps along it. flat: cut off at its end."""
        line = curve(path)
        at = np.linspace(0, 1, len(line))
        if flat:  # goes on a little, and is cut straight there
            way = line[-1] - line[-2]
            line = np.vstack([line, line[-1] + way / np.hypot(*way) * widths[-1]])
            at = np.append(at, 1)
        radii = np.interp(at, np.linspace(0, 1, len(widths)), widths)
        radii *= 1 + 0.05 * np.sin(self.random.uniform(0, 7) + at * self.random.uniform(3, 8))
        discs = [MultiPoint([p]).buffer(r, 12) for p, r in zip(line, radii)]
        shape = unary_union([a.union(b).convex_hull for a, b in zip(discs, discs[1:])])
        if flat:
            way = (line[-1] - line[-2]) / np.hypot(*(line[-1] - line[-2]))
            side = np.array([-way[1], way[0]]) * widths[-1] * 3
            far = way * widths[-1] * 3
            end = line[-1] + way * 0.1 * widths[-1]
            shape = shape.difference(Polygon([end - side, end + side, end + side + far,
                                              end - side + far]))
        self.shapes.append(shape)

    def blob(self, centre, rx, ry=None, turn=0, bumps=0.04):
        """An uneven ellipse, turned by degrees."""
        ry = ry or rx
        angles = np.linspace(0, 2 * math.pi, 72, endpoint=False)
        r = 1 + sum(bumps / k * np.sin(k * angles + self.random.uniform(0, 7)) for k in (2, 3, 5))
        x, y = rx * r * np.cos(angles), ry * r * np.sin(angles)
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        self.shapes.append(Polygon(np.c_[centre[0] + c * x - s * y, centre[1] + s * x + c * y]))

    def poly(self, points):
        self.shapes.append(Polygon(points).buffer(0))

    def body(self, rows, sharp=False):
        """A body from top to bottom: rows of (y, half width) or (x, y, half width)."""
        rows = [(0, *row) if len(row) == 2 else row for row in rows]
        rows = np.array(rows, float) if sharp else curve(rows, 8)
        left = [(x - w, y) for x, y, w in rows]
        right = [(x + w, y) for x, y, w in rows]
        self.poly(left + right[::-1])

    def spikes(self, centre, r, first, last, count, height):
        """Hair: triangles around a circle, from one angle to another, in degrees."""
        for a in np.linspace(math.radians(first), math.radians(last), count):
            h = height * self.random.uniform(0.75, 1.2)
            w = 0.6 * abs(math.radians(last - first)) / max(count - 1, 1)
            at = [(r * 0.9, a - w), (r + h, a + self.random.uniform(-0.3, 0.3) * w), (r * 0.9, a + w)]
            self.poly([(centre[0] + q * math.cos(b), centre[1] + q * math.sin(b)) for q, b in at])

    def limb(self, name, path, widths, flat=False, wanted=True):
        """A limb of a creature, base first; wanted: an animator needs it, otherwise it may be there."""
        self.tube(path, widths, flat)
        known = {"name": name, "tip": path[-1], "base": path[0]}
        (self.limbs if wanted else self.allowed).append(known)

    def allow(self, name, tip):
        self.allowed.append({"name": name, "tip": tip})

    # From the shapes to the file.

    def outline(self):
        shape = unary_union([s.buffer(0) for s in self.shapes])
        shape = shape.buffer(3).buffer(-5).buffer(2)
        if shape.geom_type != "Polygon":
            raise ValueError(f"{self.name}: in pieces")
        return LineString(shape.exterior.coords)

    def trembling(self, line, count, closed):
        """Evenly resampled, rounded, and with a hand's slow and quick wobble across the line."""
        even = [line.interpolate(s, True).coords[0] for s in np.linspace(0, 1, 4 * count)]
        p = np.array(even[:-1] if closed else even)
        for _ in range(6):  # corners become as round as a pen's
            inner = (np.roll(p, 1, 0) + 2 * p + np.roll(p, -1, 0)) / 4
            p[1:-1] = inner[1:-1]
            if closed:
                p[[0, -1]] = inner[[0, -1]]
        step = np.roll(p, -1, 0) - np.roll(p, 1, 0)
        normal = np.c_[step[:, 1], -step[:, 0]] / np.maximum(np.hypot(*step.T), 1e-9)[:, None]
        t = np.linspace(0, (2 if closed else 1) * math.pi, len(p), endpoint=False)
        wobble = np.zeros(len(p))
        for k in list(range(5, 20)) + list(range(30, 60, 3)):
            size = 0.85 if k < 20 else 0.25
            wobble += self.random.normal(0, size) * np.sin(k * t + self.random.uniform(0, 7))
        p += normal * (self.tremor * wobble)[:, None]
        # A hand is slower in some places: samples are not quite even.
        at = np.arange(0, len(p), 4) + self.random.integers(-1, 2, len(p[::4]))
        return p[np.clip(at, 0, len(p) - 1)] + self.random.normal(0, 0.3 * self.tremor, (len(at), 2))

    def stroke(self):
        line = self.outline()
        if self.symmetry != "exact":
            p = self.trembling(line, self.count, True)
            p = np.roll(p, self.random.integers(len(p)), 0)
            return p[::-1] if self.random.random() < 0.5 else p
        # The right half, from the bottom to the top, and its mirror image.
        half = Polygon(line.coords).intersection(Polygon([(0, -999), (999, -999), (999, 999), (0, 999)]))
        parts = getattr(half, "geoms", [half])
        rim = LineString(max(parts, key=lambda g: g.area).exterior.coords)
        p = np.array(rim.coords[:-1])
        on_axis = np.flatnonzero(np.abs(p[:, 0]) < 1e-6)
        low, high = on_axis[p[on_axis, 1].argmin()], on_axis[p[on_axis, 1].argmax()]
        ways = [np.roll(p, -low, 0)[: (high - low) % len(p) + 1],
                np.roll(p, -high, 0)[: (low - high) % len(p) + 1][::-1]]
        way = max(ways, key=lambda w: w[:, 0].max())
        q = self.trembling(LineString(way), self.count // 2, False)
        q[[0, -1], 0] = 0
        q[1:-1, 0] = np.maximum(q[1:-1, 0], 0.5)
        return np.vstack([q, (q * (-1, 1))[-2:0:-1]])

    def write(self, folder):
        p = self.stroke()
        while not Polygon(p).is_valid:  # where it is narrow, the hand is steadier
            self.tremor *= 0.7
            p = self.stroke()
        low, high = p.min(0), p.max(0)
        middle, scale = (low + high) / 2, SIZE / (high - low).max()
        if self.symmetry == "exact":
            middle[0] = 0

        def put(q):
            x, y = (np.asarray(q, float) - middle) * scale
            return [round(float(x), 2) + 0.0, round(float(y), 2) + 0.0]

        out = {"name": self.name, "kind": self.kind, "symmetry": self.symmetry, "closed": True}
        if self.joints:
            out["joints"] = {name: put(q) for name, q in self.joints.items()}
            out.update(bends(self.joints))
        if self.limbs:
            out["limbs"] = [{k: v if k == "name" else put(v) for k, v in limb.items()}
                            for limb in self.limbs]
        if self.allowed:
            out["allowed"] = [{"name": limb["name"], "tip": put(limb["tip"])} for limb in self.allowed]
        rows = [f'  "{key}": {json.dumps(value)}' for key, value in out.items()]
        rows.append('  "points": ' + json.dumps([put(q) for q in p]))
        Path(folder, self.name + ".json").write_text("{\n" + ",\n".join(rows) + "\n}\n")


def bends(joints):
    """Which elbows and knees are straight (within 25 degrees) and which are bent."""
    out = {"straight": [], "bent": []}
    for side in ("right", "left"):
        for chain in (("shoulder", "elbow", "hand"), ("hip", "knee", "foot")):
            if f"{side}_{chain[0]}" not in joints:
                continue
            a, b, c = (np.array(joints[f"{side}_{name}"], float) for name in chain)
            u, v = b - a, c - b
            turn = abs(math.degrees(math.atan2(u[0] * v[1] - u[1] * v[0], u @ v)))
            out["straight" if turn < 25 else "bent"].append(f"{side}_{chain[1]}")
    return out


if __name__ == "__main__":
    here = Path(__file__).resolve().parent
    sys.path.insert(0, str(here))
    import bipeds
    import creatures
    for drawing in bipeds.all() + creatures.all():
        drawing.write(sys.argv[1] if len(sys.argv) > 1 else here)
