"""Packed sets (packed_set.h), and batches of their lights, as a photographer's solved sets might be."""
import numpy as np
import torch
import torch.nn.functional as F

import umbra_net

MOST_LIGHTS = 5


def read_pack(path, width, height):
    """Lights x 4 x height x width bytes of each set."""
    data, at, sets = np.fromfile(path, np.uint8), 0, []
    while at < len(data):
        lights = int(data[at:at + 4].view(np.int32)[0])
        size = lights * 4 * height * width
        sets.append(data[at + 4:at + 4 + size].reshape(lights, 4, height, width))
        at += 4 + size
    return sets


class Sets:
    """Sets of one size on the device, those of a single light left out."""

    def __init__(self, sets, device):
        sets = [s[:MOST_LIGHTS] for s in sets if len(s) >= 2]
        shape = sets[0].shape[1:]
        planes = torch.zeros((len(sets), MOST_LIGHTS, *shape), dtype=torch.uint8)
        for i, s in enumerate(sets):
            planes[i, :len(s)] = torch.from_numpy(s)
        self.planes = planes.to(device)
        self.lights = torch.tensor([len(s) for s in sets]).to(device)

    def __len__(self):
        return len(self.lights)

    def take(self, which, light):
        """Contributions, the chosen light first; which lights are present; the visibility of the first."""
        device, batch = self.planes.device, len(which)
        lights = self.lights[which][:, None]
        present = torch.arange(MOST_LIGHTS, device=device) < lights
        order = torch.rand(batch, MOST_LIGHTS, device=device) + ~present * 10.  # those that are not there last
        order.scatter_(1, light[:, None], -1.)
        planes = self.planes[which[:, None], order.argsort(1)]
        return _decoded(planes[:, :, :3]), present.float(), planes[:, 0, 3:4].float() / 255


def _decoded(levels):
    levels = levels.float()
    return torch.where(levels > 0, torch.exp2((levels - 255) / 16 + 2), torch.zeros_like(levels))


def _each(factors):
    """One number a light, over its planes."""
    return factors[:, :, None, None, None]


def _one(batch, device):
    return torch.rand(batch, 1, 1, 1, 1, device=device)


def _averaged(contributions, **options):
    return F.avg_pool2d(contributions.flatten(1, 2), 3, 1, 1, **options).unflatten(1, contributions.shape[1:3])


def _some_lights_out(present):
    """About every seventh of the other lights missing; the first of them seldom, so that few lights are alone."""
    out = torch.rand(present.shape, device=present.device) < .15
    out[:, 0] = False
    out[:, 1] &= torch.rand(len(present), device=present.device) < .2
    return present * ~out


def _other_levels(contributions, present):
    """Lights of other strengths, up to 5 stops apart; now and then not quite linear, or not quite separated."""
    batch, device = len(present), present.device
    power = torch.exp2(-5 * torch.rand(batch, MOST_LIGHTS, device=device) ** 1.5)
    contributions = contributions * _each(power * present)
    exponent = torch.exp2(.2 * (2 * _one(batch, device) - 1) * (_one(batch, device) < .25))
    contributions = contributions ** exponent
    leak = torch.randn(batch, MOST_LIGHTS, device=device) * .01 * (torch.rand(batch, 1, device=device) < .3)
    leak[:, 0] = 0
    contributions[:, 0] += (contributions * _each(leak)).sum(1)
    return contributions


def _other_view(contributions, visibility):
    """Larger or smaller, a part of it of whole steps, mirrored or on its side: alike for the whole batch."""
    height, width = contributions.shape[-2:]
    scale = float(torch.empty(1).uniform_(.75, 1.35)) if torch.rand(1) < .7 else 1.
    if scale != 1:
        height, width = int(height * scale), int(width * scale)
        planes = torch.cat([contributions.flatten(1, 2), visibility], 1)
        planes = F.interpolate(planes, size=(height, width), mode='bilinear', align_corners=False, antialias=scale < 1)
        contributions, visibility = planes[:, :-1].unflatten(1, contributions.shape[1:3]), planes[:, -1:]
    rows, columns = height // umbra_net.STEP * umbra_net.STEP, width // umbra_net.STEP * umbra_net.STEP
    y, x = int(torch.randint(height - rows + 1, (1,))), int(torch.randint(width - columns + 1, (1,)))
    views = [planes[..., y:y + rows, x:x + columns] for planes in (contributions, visibility)]
    for dims, probability in (((-1,), .5), ((-2,), .1)):
        if torch.rand(1) < probability:
            views = [planes.flip(dims) for planes in views]
    if torch.rand(1) < .1:
        views = [planes.transpose(-1, -2) for planes in views]
    return views


def _with_noise(contributions, present, amount, noise):
    """As of a sensor with a read noise of .4 % and 5000 electrons, times `amount`: every light gets that of the sum.
    `noise`: of deviation 1."""
    total = contributions.sum(1, keepdim=True)
    top = umbra_net.brightest(total[:, 0].mean(1))[:, None, None, None, None]
    deviation = amount * torch.sqrt(.004 ** 2 + (total / top).clamp(min=0) / 5000) * top
    return contributions + deviation * noise * _each(present)


def training_batch(sets, size):
    """Evidence and visibility of lights drawn from the sets, each in another guise every time."""
    device = sets.planes.device
    which = torch.randint(len(sets), (size,), device=device)
    light = (torch.rand(size, device=device) * sets.lights[which]).long()
    contributions, present, visibility = sets.take(which, light)
    present = _some_lights_out(present)
    contributions = _other_levels(contributions, present)
    contributions, visibility = _other_view(contributions, visibility)
    amount = torch.exp2(-4 * _one(size, device)) * 1.5 * (_one(size, device) < .65)
    noise = torch.randn(contributions.shape, device=device)
    if torch.rand(1) < .5:  # neighbours have some of it in common, as after a solve
        noise = _averaged(noise) * 2 * .7 + noise * .3
    contributions = _with_noise(contributions, present, amount, noise)
    if torch.rand(1) < .2:  # as a solver that pools neighbours would give it
        contributions = _averaged(contributions, count_include_pad=False)
    return umbra_net.evidence(contributions, present), visibility[:, 0]


def judging_batch(sets, which, noise):
    """All lights of a set as they are, or with noise."""
    device, lights = sets.planes.device, int(sets.lights[which])
    light = torch.arange(lights, device=device)
    contributions, present, visibility = sets.take(torch.full((lights,), which, device=device), light)
    contributions = contributions * .6 * _each(present)
    if noise:
        contributions = _with_noise(contributions, present, noise, torch.randn(contributions.shape, device=device))
    return umbra_net.evidence(contributions, present), visibility[:, 0]
