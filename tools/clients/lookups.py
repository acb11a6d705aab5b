"""How renderers that are not installed here find the pixels of a direction, written from their documentation, without skylut's code.

All take a picture as a function pixel(column, row) -> (R, G, B) with its width and height, and a direction (east, north, up).
"""

import math


def pbrt_square(x, y, z):
    """Point of the equal-area square, [0, 1] x [0, 1] from its first pixel, of a unit vector in the light's own axes: Clarberg 2008
    (doi 10.1080/2151237X.2008.10129263), Physically Based Rendering, 4th edition, sec. 3.8.3."""
    radius = math.sqrt(max(0.0, 1 - abs(z)))
    turn = math.atan2(abs(y), abs(x)) * 2 / math.pi
    v = turn * radius
    u = radius - v
    if z < 0:
        u, v = 1 - v, 1 - u
    return (math.copysign(u, x) + 1) / 2, (math.copysign(v, y) + 1) / 2


def pbrt(pixel, width, height, direction):
    """pbrt-v4, light "infinite" with a file: the nearest pixel of the square; x east, y north, z up."""
    u, v = pbrt_square(*direction)
    return pixel(min(width - 1, int(u * width)), min(height - 1, int(v * height)))


def bilinear(pixel, width, height, column, row):
    """Between the centres of four pixels; the picture closes in itself from right to left."""
    left, top = math.floor(column), min(max(math.floor(row), 0), height - 2)
    right_share, lower_share = column - left, min(max(row - top, 0.0), 1.0)
    corners = [pixel((left + i) % width, top + j) for j in (0, 1) for i in (0, 1)]
    shares = [(1 - right_share) * (1 - lower_share), right_share * (1 - lower_share),
              (1 - right_share) * lower_share, right_share * lower_share]
    return [sum(share * corner[k] for share, corner in zip(shares, corners)) for k in range(3)]


def mitsuba(pixel, width, height, direction):
    """Mitsuba 3, emitter "envmap": +Y up, u = atan2(x, -z)/2π, v = acos(y)/π. The picture as it is puts x north and z east. Columns
    are looked up at their centres (in versions that shift by half a texel), but the first and last row lie on the poles."""
    east, north, up = direction
    x, y, z = north, up, east
    u = math.atan2(x, -z) / (2 * math.pi) % 1
    v = math.acos(max(-1.0, min(1.0, y))) / math.pi
    return bilinear(pixel, width, height, u * width - 0.5, v * (height - 1))


def openexr_latlong(pixel, width, height, direction):
    """The latitude-longitude maps of OpenEXR's technical introduction: +Y up; longitude atan2(x, z) from +π at the left to -π at the
    right, latitude from +π/2 in the first row, with the centres of the outermost pixels on the borders: a half pixel off at most, and
    nothing in the middle. The picture as it is has z east and x north."""
    east, north, up = direction
    x, y, z = north, up, east
    longitude = math.atan2(x, z)
    latitude = math.asin(max(-1.0, min(1.0, y)))
    return bilinear(pixel, width, height, (0.5 - longitude / (2 * math.pi)) * (width - 1),
                    (0.5 - latitude / math.pi) * (height - 1))
