#!/usr/bin/env python3
"""Known answers of DifficultyTest.cpp, measured in the files of a case apart from the program: Python 3.11 alone.

    insonate-cli phantom CASE --variant textbook   # also: vein-over-artery, arm, groin
    python3 tests/unit/cases/vein_measures.py CASE

Reads labels.seg.nrrd and case.json. The direction of the vein is the line through the centroids of the vein in slices
across it; the program uses the main axis of the voxels in a ball instead. The section is perpendicular to this line
and contains the beam of the nearest start pose that points at the target. Lengths and areas come from points 0.1 mm
apart; the program uses points 0.25 mm apart. Nothing here follows the C++ code.
"""
import gzip
import json
import math
import pathlib
import sys

VEIN, ARTERY = 6, 2
STEP_MM, HALF_WIDTH_MM, ABOVE_MM, BELOW_MM = 0.1, 18, 40, 25


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def along(a, s, b):
    """a + s b"""
    return tuple(x + s * y for x, y in zip(a, b))


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


class Labels:
    """The label map of a case on an axis-aligned grid."""

    def __init__(self, file):
        head, _, packed = file.read_bytes().partition(b"\n\n")
        fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line and ":=" not in line)
        assert (fields["encoding"], fields["type"]) == ("gzip", "unsigned char")
        assert fields["space"] == "left-posterior-superior"
        self.voxels = gzip.decompress(packed)
        self.size = [int(n) for n in fields["sizes"].split()]
        numbers = fields["space directions"].replace("(", " ").replace(")", " ").replace(",", " ").split()
        self.spacing = [float(numbers[4 * axis]) for axis in range(3)]
        assert sum(float(n) != 0 for n in numbers) == 3
        self.origin = [float(n) for n in fields["space origin"].strip("()").split(",")]

    def at(self, place):
        index = [math.floor((p - o) / s + 0.5) for p, o, s in zip(place, self.origin, self.spacing)]
        if any(i < 0 or i >= n for i, n in zip(index, self.size)):
            return 0
        return self.voxels[index[0] + self.size[0] * (index[1] + self.size[1] * index[2])]


def connected(inside, start):
    """The points of a grid that are connected with `start`."""
    region, waiting = {start}, [start]
    while waiting:
        x, y = waiting.pop()
        for beside in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
            if beside in inside and beside not in region:
                region.add(beside)
                waiting.append(beside)
    return region


def centroid(labels, middle, first, second):
    """Centroid of the vein in the plane through `middle` that two directions span; points 0.25 mm apart."""
    step, reach = 0.25, 48
    grid = {(i, j): along(along(middle, i * step, first), j * step, second)
            for i in range(-reach, reach + 1) for j in range(-reach, reach + 1)}
    inside = {point for point, place in grid.items() if labels.at(place) == VEIN}
    nearest = min(inside, key=lambda point: point[0] ** 2 + point[1] ** 2)
    region = connected(inside, nearest)
    mean = [sum(point[n] for point in region) / len(region) for n in (0, 1)]
    return along(along(middle, mean[0] * step, first), mean[1] * step, second)


def direction_of_vein(labels, target):
    """Least squares line through centroids, up to 8 mm from the target; begins with the axis of the slices."""
    axis = (0.0, 0.0, 1.0)
    for _ in range(3):
        first = unit(cross(axis, (0.3, 1.0, 0.2)))
        second = cross(axis, first)
        centers = []
        middle = target
        for sign in (1, -1):
            middle = target
            for n in range(0 if sign > 0 else 1, 9):
                middle = centroid(labels, along(middle, sign * (n > 0), axis), first, second)
                centers.append((sign * n, middle))
        square = sum(n * n for n, _ in centers)
        axis = unit(tuple(sum(n * center[k] for n, center in centers) / square for k in range(3)))
    return axis


def measures(folder):
    labels = Labels(folder / "labels.seg.nrrd")
    case = json.loads((folder / "case.json").read_text())
    target = tuple(case["targets"][0]["position_mm"])
    assert labels.at(target) == VEIN

    def beside(pose):
        to = along(target, -1, pose["position_mm"])
        return math.dist(to, tuple(dot(to, pose["axial"]) * x for x in pose["axial"]))

    poses = [pose for pose in case["start_poses"] if beside(pose) <= 12]
    beam = tuple(min(poses, key=lambda pose: math.dist(pose["position_mm"], target))["axial"])
    axis = direction_of_vein(labels, target)
    into = unit(along(beam, -dot(beam, axis), axis))
    aside = unit(cross(axis, into))
    rows, columns = range(-round(ABOVE_MM / STEP_MM), round(BELOW_MM / STEP_MM)), round(HALF_WIDTH_MM / STEP_MM)
    section = {(x, y): labels.at(along(along(target, x * STEP_MM, aside), y * STEP_MM, into))
               for x in range(-columns, columns + 1) for y in rows}
    vein = connected({point for point, label in section.items() if label == VEIN}, (0, 0))
    left = {point for point, label in section.items() if label == ARTERY}
    arteries = []
    while left:
        arteries.append(connected(left, next(iter(left))))
        left -= arteries[-1]
    skin = max(y for y in rows if y < 0 and section[0, y] == 0) + 1
    area = len(vein) * STEP_MM ** 2
    depth = (min(y for _, y in vein) - skin) * STEP_MM
    print(f"{case['targets'][0]['name']}: depth {depth:.1f} mm, area {area:.1f} mm2")
    mean = [sum(point[n] for point in vein) / len(vein) for n in (0, 1)]
    xx, yy, xy = (sum((p[a] - mean[a]) * (p[b] - mean[b]) for p in vein) / len(vein)
                  for a, b in ((0, 0), (1, 1), (0, 1)))
    spread = math.hypot((xx - yy) / 2, xy)
    print(f"  width {4 * STEP_MM * math.sqrt((xx + yy) / 2 + spread):.1f} mm, "
          f"height {4 * STEP_MM * math.sqrt((xx + yy) / 2 - spread):.1f} mm")

    # Seen from the front of the patient: which part of the artery's width lies behind the vein.
    back = unit((0.0, dot((0, 1, 0), aside), dot((0, 1, 0), into)))[1:]
    across = lambda point: point[0] * back[1] - point[1] * back[0]
    edge = [p for p in vein if any((p[0] + dx, p[1] + dy) not in vein for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)))]
    gap = {n: min(math.dist(a, b) for a in artery for b in edge[::4]) * STEP_MM
           for n, artery in enumerate(arteries) if len(artery) * STEP_MM ** 2 >= 6}
    artery = arteries[min(gap, key=gap.get)]
    center = [sum(point[n] for point in artery) / len(artery) - mean[n] for n in (0, 1)]
    from_, to = min(map(across, artery)), max(map(across, artery))
    both = min(to, max(map(across, vein))) - max(from_, min(map(across, vein)))
    is_behind = center[0] * back[0] + center[1] * back[1] > 0
    overlap = 100 * max(0.0, both) / (to - from_) if is_behind else 0.0
    print(f"  artery {min(gap.values()):.1f} mm from the vein, {overlap:.0f} % of it behind the vein")


if __name__ == "__main__":
    measures(pathlib.Path(sys.argv[1]))
