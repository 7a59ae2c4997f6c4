"""The network that tells umbra: what it looks at, its layers, and its loss.

Tensors are batch x lights x 3 x height x width (contributions, linear, the light that is asked about first), batch x
lights (present: 1 or 0) or batch x height x width (one plane).
"""
import torch
import torch.nn as nn
import torch.nn.functional as F

# Visibility below which a pixel is in umbra, and above which it is lit; penumbra lies between.
UMBRA, LIT = .02, .98
UMBRA_CLASS, PENUMBRA_CLASS, LIT_CLASS = range(3)

# As in core/shadow/odds/umbra_evidence.cpp, which computes the same for the program.
FLOOR = 5e-4      # of the brightest: what is darker is all alike
MOST_COLOUR = 2   # log
BRIGHTEST = .99   # share of the pixels that are not above

EVIDENCE = 10                        # planes that the network gets
WIDTHS = (16, 32, 48, 48, 48, 48)    # channels at each size of the picture, from full size down
STEP = 2 ** (len(WIDTHS) - 1)        # height and width are multiples of it


def brightest(plane):
    """The 99th percentile of each picture of a batch."""
    pixels = plane.flatten(1)
    rank = int(round(BRIGHTEST * (pixels.shape[1] - 1))) + 1
    return pixels.kthvalue(rank, 1).values.clamp(min=1e-9)


def log_over(plane, top, floor=FLOOR):
    return torch.log(plane.clamp(min=0) / top[:, None, None] + floor)


def colour(rgb, top):
    """The logs of red and of blue over green."""
    red, green, blue = (log_over(rgb[:, c], top, 2 * FLOOR) for c in range(3))
    return (red - green).clamp(-MOST_COLOUR, MOST_COLOUR), (blue - green).clamp(-MOST_COLOUR, MOST_COLOUR)


def other_lights(grey, tops, present):
    """Mean, highest and lowest log level of the other lights; 0 where there is none."""
    logs = torch.log(grey[:, 1:].clamp(min=0) / tops[:, 1:, None, None].clamp(min=1e-6) + FLOOR)
    there = present[:, 1:, None, None]
    count = present[:, 1:].sum(1)[:, None, None]
    mean = (logs * there).sum(1) / count.clamp(min=1)
    highest = torch.where(there > 0, logs, torch.full_like(logs, -99)).amax(1)
    lowest = torch.where(there > 0, logs, torch.full_like(logs, 99)).amin(1)
    return [torch.where(count > 0, plane, torch.zeros_like(plane)) for plane in (mean, highest, lowest)]


def evidence(contributions, present):
    """What the network gets: batch x EVIDENCE x height x width. Scales and offsets bring each to about -1 to 1."""
    grey = contributions.mean(2) * present[:, :, None, None]
    total = grey.sum(1)
    tops = torch.stack([brightest(grey[:, i]) for i in range(grey.shape[1])], 1)
    own, all_ = tops[:, 0], brightest(total)
    level = log_over(grey[:, 0], own)
    others = log_over(total - grey[:, 0], all_)
    share = level - log_over(total, all_)
    other_rgb = (contributions[:, 1:] * present[:, 1:, None, None, None]).sum(1)
    mean, highest, lowest = other_lights(grey, tops, present)
    return torch.stack([.5 * level + 1, .5 * others + 1, .5 * share, *colour(contributions[:, 0], own),
                        *colour(other_rgb, all_), .5 * mean + 1, .5 * highest + .5, .5 * lowest + 1.5], 1)


class Block(nn.Sequential):
    """Two convolutions of 3 x 3, each normalised over the batch."""

    def __init__(self, channels_in, channels):
        super().__init__(
            nn.Conv2d(channels_in, channels, 3, padding=1, bias=False), nn.BatchNorm2d(channels), nn.ReLU(True),
            nn.Conv2d(channels, channels, 3, padding=1, bias=False), nn.BatchNorm2d(channels), nn.ReLU(True))


class UmbraNet(nn.Module):
    """A U-Net (Ronneberger et al., MICCAI 2015). Four planes come out: scores of umbra, penumbra and lit, whose softmax
    are probabilities, and the logit of the visibility."""

    def __init__(self):
        super().__init__()
        into = (EVIDENCE, *WIDTHS)
        self.encoder = nn.ModuleList(Block(a, b) for a, b in zip(into, WIDTHS))
        self.decoder = nn.ModuleList(Block(a + b, a) for a, b in zip(WIDTHS, WIDTHS[1:]))
        self.head = nn.Conv2d(WIDTHS[0], 4, 1)

    def forward(self, x):
        kept = []
        for i, block in enumerate(self.encoder):
            x = block(F.max_pool2d(x, 2) if i else x)
            kept.append(x)
        for i in reversed(range(len(self.decoder))):
            x = F.interpolate(x, scale_factor=2, mode='nearest')
            x = self.decoder[i](torch.cat([x, kept[i]], 1))
        return self.head(x)


def class_of(visibility):
    return torch.where(visibility < UMBRA, UMBRA_CLASS, torch.where(visibility > LIT, LIT_CLASS, PENUMBRA_CLASS))


def loss_of(scores, visibility):
    """Cross entropy of the classes, half the soft Jaccard distance of umbra, and the visibility's mean error.

    A light's umbra weighs more the smaller its share of the picture, as the share's root says: else it could be missed
    at little cost. Jaccard distances of lights without umbra to speak of count nothing.
    """
    scores = scores.float()
    truth = class_of(visibility)
    umbra = (truth == UMBRA_CLASS).float()
    share = umbra.mean((1, 2))
    weight = share.sqrt() / (share.sqrt() + (1 - share).sqrt()).clamp(min=1e-6)
    of_umbra = (weight / share.clamp(min=1e-4))[:, None, None]
    of_others = ((1 - weight) / (1 - share).clamp(min=1e-4))[:, None, None]
    entropy = F.cross_entropy(scores[:, :3], truth, reduction='none')
    entropy = (entropy * torch.where(truth == UMBRA_CLASS, of_umbra, of_others)).mean((1, 2))
    told = scores[:, :3].softmax(1)[:, UMBRA_CLASS]
    both, either = (told * umbra).sum((1, 2)), (told + umbra - told * umbra).sum((1, 2))
    jaccard = (1 - both / either.clamp(min=1)) * (share > .002)
    error = (torch.sigmoid(scores[:, 3]) - visibility).abs().mean((1, 2))
    return (entropy + .5 * jaccard + error).mean()
