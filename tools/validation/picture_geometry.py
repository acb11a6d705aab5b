"""Cosine of the zenith angle and solid angle of every pixel of the projections, from their definitions: arrays [row][column]."""

import numpy


def centres(width, height):
    """Pixel centres from -1 to 1, y downwards."""
    return numpy.meshgrid((numpy.arange(width) + 0.5) * 2 / width - 1, (numpy.arange(height) + 0.5) * 2 / height - 1)


def latlong(width, height):
    edges = numpy.cos(numpy.arange(height + 1) * numpy.pi / height)
    band = (edges[:-1] - edges[1:]) * 2 * numpy.pi / width
    return (numpy.repeat(((edges[:-1] + edges[1:]) / 2)[:, None], width, axis=1), numpy.repeat(band[:, None], width, axis=1))


def fisheye(width, height):
    """Zenith angle r·90°: dΩ = sin θ dθ dφ, and a pixel is dA = r dr dφ. Pixels cut by the circle count by the part inside."""
    x, y = centres(width, height)
    radius = numpy.hypot(x, y)
    angle = radius * numpy.pi / 2
    return numpy.cos(angle), numpy.sinc(angle / numpy.pi) * (numpy.pi / 2)**2 * 4 / (width * height) * inside(x, y, width)


def fisheye_equisolid(width, height):
    """r² = 1 - cos θ: equal solid angles on equal areas, 2π over the disc of area π."""
    x, y = centres(width, height)
    return 1 - x**2 - y**2, numpy.full_like(x, 2 * 4 / (width * height)) * inside(x, y, width)


def inside(x, y, width, parts=16):
    """Share of each pixel in the unit circle."""
    offsets = ((numpy.arange(parts) + 0.5) / parts - 0.5) * 2 / width
    return sum((numpy.hypot(x + i, y + j) < 1).astype(float) for i in offsets for j in offsets) / parts**2


def face_solid_angle(x, y, width):
    """Of the square faces of a cube, by the corners."""
    half = 1 / width

    def corner(a, b):
        return numpy.arctan2(a * b, numpy.sqrt(a * a + b * b + 1))
    return corner(x + half, y + half) - corner(x - half, y + half) - corner(x + half, y - half) + corner(x - half, y - half)


def side(width, height):
    x, y = centres(width, height)
    return -y / numpy.sqrt(1 + x * x + y * y), face_solid_angle(x, y, width)


def top(width, height):
    x, y = centres(width, height)
    return 1 / numpy.sqrt(1 + x * x + y * y), face_solid_angle(x, y, width)


def cross(width, height):
    """Four faces wide, three high: the top above one of the four sides in the middle row; the bottom does not count."""
    size = height // 3
    up, solid_angle = numpy.zeros((height, width)), numpy.zeros((height, width))
    for column in range(4):
        part = (slice(size, 2 * size), slice(column * size, (column + 1) * size))
        up[part], solid_angle[part] = side(size, size)
    for column in range(4):
        part = (slice(0, size), slice(column * size, (column + 1) * size))
        up[part], solid_angle[part] = top(size, size)  # three of them are empty: no luminance
    return up, solid_angle


def octahedral(width, height):
    """Clarberg 2008: equal areas; |z| = 1 - r² with r = 1 - |1 - |u| - |v||, above the horizon where |u| + |v| < 1."""
    x, y = centres(width, height)
    edge = 1 - abs(x) - abs(y)
    return numpy.sign(edge) * (1 - (1 - abs(edge))**2), numpy.full_like(x, 4 * numpy.pi / (width * height))


GEOMETRY = {"latlong": latlong, "fisheye": fisheye, "fisheye-equisolid": fisheye_equisolid, "cube-cross": cross, "octahedral": octahedral,
            "cube-py": top, "cube-px": side, "cube-nx": side, "cube-pz": side, "cube-nz": side}
