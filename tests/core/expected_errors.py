#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Prints the table of expected values in error_meter_test.cpp. Needs Debian's python3-skimage and
# python3-opencv, which the project itself does not; run it when the table is to grow.
#
# SSIM and PSNR are scikit-image's. FLIP is evaluated as its definition is written, with filters in
# two dimensions by OpenCV and in double precision, where flip.cpp has passes along rows and columns
# in single precision.
import cv2
import numpy as np
from skimage.metrics import peak_signal_noise_ratio, structural_similarity

WIDTH, HEIGHT = 96, 80


def hashed(x, y, c):
    """A number in [0, 255] that looks random; the same as in error_meter_test.cpp."""
    h = (x * 73856093 ^ y * 19349663 ^ c * 83492791) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    return (h >> 16) & 255


def image(of):
    """8-bit colours; of(x, y) gives three integers."""
    return np.array([[of(x, y) for x in range(WIDTH)] for y in range(HEIGHT)], float) / 255


def gradient(x, y):
    return (x * 255 // (WIDTH - 1), y * 255 // (HEIGHT - 1), (x + y) * 255 // (WIDTH + HEIGHT - 2))


def tiles(x, y):
    return (230, 40, 30) if (x // 12 + y // 10) % 2 else (20, 60, 200)


def disc(x, y):
    return (250, 240, 200) if (x - 47) ** 2 + (y - 40) ** 2 < 900 else (30, 35, 60)


def noisy(of, amount):
    return lambda x, y: tuple(
        max(0, min(255, v + (hashed(x, y, c) - 128) * amount // 128)) for c, v in enumerate(of(x, y)))


def blocks(of, size):
    return lambda x, y: of(x // size * size, y // size * size)


def shifted(of, dx):
    return lambda x, y: of(x - dx, y)


PAIRS = [
    ("noisy gradient", gradient, noisy(gradient, 24)),
    ("blocks of tiles", tiles, blocks(tiles, 8)),
    ("disc shifted", disc, shifted(disc, 3)),
    ("disc without colour", disc, lambda x, y: (sum(disc(x, y)) // 3,) * 3),
    ("green against blue", lambda x, y: (0, 255, 0), lambda x, y: (0, 0, 255)),
]

# ---- FLIP as in Andersson et al. 2020

PPD = 0.7 * 3840 / 0.7 * np.pi / 180
XYZ = np.array([[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
                [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
                [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]])
WHITE = XYZ.sum(axis=1)


def opponent(srgb):
    linear = np.where(srgb > 0.04045, ((srgb + 0.055) / 1.055) ** 2.4, srgb / 12.92)
    x, y, z = np.moveaxis(linear @ XYZ.T / WHITE, 2, 0)
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def correlate(plane, kernel):
    return cv2.filter2D(plane, cv2.CV_64F, kernel, borderType=cv2.BORDER_REPLICATE)


def sensitivity(*terms):
    r = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi ** 2)) * PPD))
    x, y = np.meshgrid(np.arange(-r, r + 1), np.arange(-r, r + 1))
    z = (x ** 2 + y ** 2) / PPD ** 2
    s = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi ** 2 * z / b) for a, b in terms)
    return s / s.sum()


def hunt_lab(xyz):
    t = xyz / WHITE
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t / (3 * (6 / 29) ** 2) + 4 / 29)
    x, y, z = np.moveaxis(f, -1, 0)
    lightness = 116 * y - 16
    return np.stack([lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)])


def seen_colour(channels):
    y, cx, cz = (correlate(c, k) for c, k in zip(channels, (
        sensitivity((1, 0.0047)), sensitivity((1, 0.0053)), sensitivity((34.1, 0.04), (13.5, 0.025)))))
    fy = (y + 16) / 116
    xyz = np.stack([fy + cx / 500, fy, fy - cz / 200], axis=-1) * WHITE
    return hunt_lab(np.clip(xyz @ np.linalg.inv(XYZ).T, 0, 1) @ XYZ.T)


def feature(luminance, point):
    sd = 0.5 * 0.082 * PPD
    r = int(np.ceil(3 * sd))
    x, y = np.meshgrid(np.arange(-r, r + 1), np.arange(-r, r + 1))
    g = np.exp(-(x ** 2 + y ** 2) / (2 * sd ** 2)) * (x ** 2 / sd ** 2 - 1 if point else -x)
    g = np.where(g < 0, g / -g[g < 0].sum(), g / g[g > 0].sum())
    return np.hypot(correlate(luminance, g), correlate(luminance, g.T.copy()))


def hyab(a, b):
    d = a - b
    return np.abs(d[0]) + np.hypot(d[1], d[2])


def flip(reference, test):
    r, t = opponent(reference), opponent(test)
    greatest = hyab(hunt_lab(XYZ @ [0, 1, 0]), hunt_lab(XYZ @ [0, 0, 1])) ** 0.7
    d = hyab(seen_colour(r), seen_colour(t)) ** 0.7
    knee = 0.4 * greatest
    colour = np.where(d < knee, 0.95 / knee * d, 0.95 + (d - knee) / (greatest - knee) * 0.05)
    ry, ty = (r[0] + 16) / 116, (t[0] + 16) / 116
    f = np.maximum(*(np.abs(feature(ry, p) - feature(ty, p)) for p in (False, True)))
    return (colour ** (1 - np.sqrt(f / np.sqrt(2)))).mean()


def luma(rgb):
    return rgb @ [0.299, 0.587, 0.114]


for name, reference, test in PAIRS:
    a, b = image(reference), image(test)
    print('{"%s", %.5f, %.6f, %.6f},' % (
        name, peak_signal_noise_ratio(a, b, data_range=1),
        structural_similarity(luma(a), luma(b), gaussian_weights=True, sigma=1.5,
                              use_sample_covariance=False, data_range=1), flip(a, b)))
