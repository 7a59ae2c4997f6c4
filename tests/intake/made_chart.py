"""A photograph of a Macbeth chart in perspective, for the tests of this folder and of the studio."""
import numpy as np

# What the patches reflect, linear Rec.709, by the maker's L*a*b*, as OpenCV has it.
REFLECTED = [(.1730, .0821, .0567), (.5683, .2927, .2184), (.1037, .1959, .3314), (.1016, .1489, .0519),
             (.2216, .2158, .4346), (.1081, .5144, .4126), (.7474, .2006, .0281), (.0576, .1052, .4030),
             (.5668, .0842, .1197), (.1110, .0423, .1429), (.3455, .5087, .0494), (.7946, .3594, .0205),
             (.0171, .0502, .2922), (.0560, .3002, .0687), (.4559, .0303, .0409), (.8574, .5676, .0069),
             (.5335, .0886, .3075), (-.0374, .2470, .4004), (.9126, .9149, .8937), (.5798, .5920, .5933),
             (.3549, .3654, .3676), (.1901, .1919, .1931), (.0853, .0889, .0926), (.0303, .0311, .0327)]
CORNERS = [(120, 90), (545, 80), (560, 380), (110, 370)]


def homography(corners):
    """From pixels to the chart, in which the patches' outer corners are 0..1."""
    rows, right = [], []
    for (x, y), (u, v) in zip(corners, ((0, 0), (1, 0), (1, 1), (0, 1))):
        rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
        right += [u, v]
    return np.append(np.linalg.solve(np.array(rows, float), np.array(right, float)), 1).reshape(3, 3)


def photograph(light, camera=np.eye(3), size=(480, 680), noise=.002):
    y, x = np.mgrid[:size[0], :size[1]]
    u, v, w = np.einsum('ij,jyx->iyx', homography(CORNERS), np.stack([x, y, np.ones_like(x)]).astype(float))
    u, v = u / w * 6.5, v / w * 4.3
    column, row = np.floor(u / 1.1).astype(int), np.floor(v / 1.1).astype(int)
    inside = (u >= 0) & (v >= 0) & (column < 6) & (row < 4) & (u - 1.1 * column <= 1) & (v - 1.1 * row <= 1)
    frame = (u > -.35) & (v > -.35) & (u < 6.85) & (v < 4.65)
    reflected = np.where(frame, .02, .3 + .05 * np.sin(x / 7) * np.sin(y / 5))[..., None] * np.ones(3)
    patch = np.clip(column + 6 * row, 0, 23)
    reflected = np.where(inside[..., None], np.array(REFLECTED)[patch], reflected)
    random = np.random.default_rng(3)
    return reflected @ camera.T * light + random.normal(size=(*size, 3)) * noise
