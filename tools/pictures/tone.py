"""From linear Rec. 709 in cd/m2 to sRGB that can be looked at."""

import numpy

LUMINANCE = (0.2126, 0.7152, 0.0722)


def geometric_mean(luminance):
    return numpy.exp(numpy.log(luminance).mean())


def tone_mapped(rgb, half_cd_m2):
    """sRGB in [0, 1]. Luminance Y becomes k/(1 + k), k = Y/half_cd_m2 (Reinhard et al. 2002); hue is kept, and colours that sRGB
    cannot show are mixed with grey of the same luminance until it can."""
    luminance = numpy.maximum(rgb @ LUMINANCE, 1e-12)
    relative = luminance / half_cd_m2
    shown = relative / (1 + relative)
    colour = rgb * (shown / luminance)[..., None]
    grey = numpy.broadcast_to(shown[..., None], colour.shape)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        room = numpy.where(colour > 1, (1 - grey) / (colour - grey), numpy.where(colour < 0, grey / (grey - colour), 1))
    colour = grey + (colour - grey) * room.min(axis=-1, keepdims=True)
    return numpy.where(colour <= 0.0031308, 12.92 * colour, 1.055 * colour.clip(1e-9) ** (1 / 2.4) - 0.055).clip(0, 1)
