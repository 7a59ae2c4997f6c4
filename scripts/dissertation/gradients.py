"""What turning the gradients of a map does to it (5.3.2.2)."""
import numpy as np
from dissertation.gloss import beta_of
from page import number, table


def integrated(x, y):
    """The map whose gradients come nearest to these: Poisson, nothing over the borders, mean 0."""
    height, width = x.shape
    gx, gy = np.zeros((height, width + 1)), np.zeros((height + 1, width))
    gx[:, 1:-1], gy[1:-1] = x[:, :-1], y[:-1]
    divergence = np.diff(gx, axis=1) + np.diff(gy, axis=0)
    mirrored = np.concatenate([divergence, divergence[::-1]], 0)
    mirrored = np.concatenate([mirrored, mirrored[:, ::-1]], 1)
    v, u = (np.arange(2 * n) * np.pi / n for n in (height, width))
    laplace = (2 * np.cos(v) - 2)[:, None] + (2 * np.cos(u) - 2)[None]
    laplace[0, 0] = 1
    spectrum = np.fft.fft2(mirrored) / laplace
    spectrum[0, 0] = 0
    return np.fft.ifft2(spectrum).real[:height, :width]


def turned(work):
    """How much of the map is left in the turned and integrated one, and how much else is there."""
    map_ = next(iter(beta_of(*work.truth('gloss/lambert')).values())).astype(float)
    map_ -= map_.mean()
    x = np.diff(map_, axis=1, append=map_[:, -1:])
    y = np.diff(map_, axis=0, append=map_[-1:])
    rows = []
    for degrees in (10, 30, 60, 90):
        angle = np.radians(degrees)
        result = integrated(np.cos(angle) * x - np.sin(angle) * y, np.sin(angle) * x + np.cos(angle) * y)
        share = (result * map_).sum() / (map_ * map_).sum()
        rest = np.sqrt(((result - share * map_) ** 2).mean() / (map_ ** 2).mean())
        rows.append([str(degrees), number(np.cos(angle), 3), number(share, 3), number(rest, 3)])
    return table(['turned by V, degrees', 'cos V', 'share of the map in the result', 'RMS of what else is there, over the map\'s'],
                 rows)
