"""thinning.py [--quick]: Zhang–Suen thinning of strokes by scikit-image, its table-driven form.

Standard input: a JSON object a line, {"stroke", "points"}. Standard output: one a line, {"bench":
"thinning", "stroke", "pixels", "ms": {"zhangSuen": [min, median]}}, or {"missing"}. The stroke is
filled at one pixel a unit; only the thinning is timed.
"""
import json
import sys
import time

try:
    import numpy
    from skimage.draw import polygon
    from skimage.morphology import skeletonize
except ImportError as error:
    print(json.dumps({"missing": str(error)}))
    sys.exit(0)


def filled(points):
    points = numpy.array(points, dtype=float)
    points -= points.min(axis=0) - 2
    size = numpy.ceil(points.max(axis=0)).astype(int) + 3
    image = numpy.zeros((size[1], size[0]), dtype=bool)
    image[polygon(points[:, 1], points[:, 0], image.shape)] = True
    return image


budget = 0.03 if "--quick" in sys.argv else 0.15
for line in sys.stdin:
    stroke = json.loads(line)
    image = filled(stroke["points"])
    times = []
    end = time.perf_counter() + budget
    while len(times) < 3 or time.perf_counter() < end:
        start = time.perf_counter()
        skeletonize(image, method="zhang")
        times.append(1000 * (time.perf_counter() - start))
    times.sort()
    print(json.dumps({"bench": "thinning", "stroke": stroke["stroke"], "pixels": int(image.sum()),
                      "ms": {"zhangSuen": [times[0], times[len(times) // 2]]}}))
