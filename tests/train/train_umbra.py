#!/usr/bin/python3
"""Teaches the network that tells umbra, judges it, and writes it as the program reads it.

usage: train_umbra.py OUT PACK,WIDTH,HEIGHT[,SHARE]... --seconds SECONDS [--judge PACK,WIDTH,HEIGHT]...
       train_umbra.py OUT [PACK,WIDTH,HEIGHT]... --export WEIGHTS [--judge PACK,WIDTH,HEIGHT]...

A PACK is of training_sets or pack_sets.py; of one with seeds (PACK.seeds), sets whose seed is divisible by 8 are held
back: the network is judged by them and by those of --judge, and never sees them. Batches come from a pack as often as
its SHARE says (1 if not said); towards the end, twice as often from the packs after the first: put drawn sets first,
for they are many but less like photographs. The learning rate falls to nothing over the SECONDS. With --export, nothing
is taught: weights of an earlier run are judged and written.

OUT, a folder, gets umbra_network.pt (weights) and umbra_network.onnx. A GPU is used where there is one; batches are
smaller without.
"""
import argparse
import copy
import inspect
import math
import pathlib
import time

import numpy as np
import torch
import torch.nn as nn
import torch.nn.functional as F

import umbra_batches
import umbra_net

DEVICE = 'cuda' if torch.cuda.is_available() else 'cpu'
BATCH = 48 if DEVICE == 'cuda' else 4  # lights
RATE, LAST_RATE, WARM_STEPS = 3e-3, 1e-5, 200
REPORT_SECONDS = 25
FALSE = .02  # of the picture: lights with more false umbra are counted


class Pack:
    """What a PACK,WIDTH,HEIGHT[,SHARE] names: sets to learn from, and those held back, if any."""

    def __init__(self, said, all_held=False):
        self.path, width, height, *share = said.split(',')
        self.share = float(share[0]) if share else 1.
        sets = umbra_batches.read_pack(self.path, int(width), int(height))
        seeds = pathlib.Path(self.path + '.seeds')
        held = [all_held] * len(sets)
        if seeds.exists() and not all_held:
            held = [int(seed) % 8 == 0 for seed in seeds.read_text().split()]
        self.taught, self.held = ([s for s, h in zip(sets, held) if h == want] for want in (False, True))
        print(f'{self.path}: {len(self.taught)} sets to learn from, {len(self.held)} to judge by', flush=True)


def iou(a, b):
    """Of each picture of a batch: intersection over union."""
    return (a & b).sum((1, 2)) / (a | b).sum((1, 2)).clamp(min=1)


def judged(net, sets, noise):
    """Of each light: IoU of umbra (NaN where there is none to speak of) and of lit, the visibility's mean error, and
    the share of the picture that is called umbra but lit."""
    rows = []
    for which in range(len(sets)):
        inputs, visibility = umbra_batches.judging_batch(sets, which, noise)
        height, width = inputs.shape[-2:]
        padding = (0, -width % umbra_net.STEP, 0, -height % umbra_net.STEP)
        scores = net(F.pad(inputs, padding, mode='replicate'))[..., :height, :width].float()
        odds, truth = scores[:, :3].softmax(1), umbra_net.class_of(visibility)
        umbra, lit = truth == umbra_net.UMBRA_CLASS, truth == umbra_net.LIT_CLASS
        told_umbra, told_lit = odds[:, umbra_net.UMBRA_CLASS] > .5, odds[:, umbra_net.LIT_CLASS] > .5
        umbra_iou = torch.where(umbra.float().mean((1, 2)) > .002, iou(told_umbra, umbra), torch.nan)
        error = (torch.sigmoid(scores[:, 3]) - visibility).abs().mean((1, 2))
        rows.append(torch.stack([umbra_iou, iou(told_lit, lit), error, (told_umbra & lit).float().mean((1, 2))], 1))
    return torch.cat(rows).cpu().numpy()


@torch.no_grad()
def judge(net, held, noises, title):
    net.eval()
    for path, sets in held:
        for noise in noises:
            rows = judged(net, sets, noise)
            _, lit, error, false = rows.mean(0)
            print(f'{title}, {path}{", noisy" if noise else ""}: {len(rows)} lights, '
                  f'umbra {np.nanmean(rows[:, 0]):.3f}, lit {lit:.3f}, error {error:.4f}, false {false:.2%}, '
                  f'{(rows[:, 3] > FALSE).sum()} with more than {FALSE:.0%}', flush=True)


class MeanWeights:
    """The running mean of a network's weights and of its normalisations: of the last tenth of the steps at first, later
    of about the last thousand (Polyak and Juditsky, "Acceleration of stochastic approximation by averaging", 1992)."""

    def __init__(self, net):
        self.net = copy.deepcopy(net)
        pairs = zip(self.net.state_dict().values(), net.state_dict().values())
        self.pairs = [(mean, now) for mean, now in pairs if mean.is_floating_point()]

    @torch.no_grad()
    def follow(self, step):
        weight = 1 - min(.999, step / (step + 10))
        if hasattr(torch, '_foreach_lerp_'):  # all at once: some hundred small tensors take long one by one
            torch._foreach_lerp_([mean for mean, _ in self.pairs], [now for _, now in self.pairs], weight)
        else:
            for mean, now in self.pairs:
                mean.lerp_(now, weight)


def train(packs, held, seconds):
    torch.manual_seed(1)
    choices = np.random.default_rng(1)
    sets = [umbra_batches.Sets(pack.taught, DEVICE) for pack in packs]
    shares = np.array([pack.share for pack in packs])
    net = umbra_net.UmbraNet().to(DEVICE).to(memory_format=torch.channels_last)
    print(f'{sum(p.numel() for p in net.parameters())} weights', flush=True)
    mean = MeanWeights(net)
    optimizer = torch.optim.AdamW(net.parameters(), lr=RATE, weight_decay=1e-3)
    begin = shown = time.time()
    step, smooth_loss = 0, None
    while (done := (time.time() - begin) / seconds) < 1:
        for group in optimizer.param_groups:
            group['lr'] = RATE * min(1, step / WARM_STEPS + .01) * (.5 + .5 * math.cos(math.pi * done)) + LAST_RATE
        now = shares * (1 + done * (np.arange(len(shares)) > 0))
        net.train()
        with torch.no_grad():
            inputs, visibility = umbra_batches.training_batch(sets[choices.choice(len(sets), p=now / now.sum())], BATCH)
        with torch.autocast(DEVICE, torch.bfloat16, enabled=DEVICE == 'cuda'):
            scores = net(inputs.to(memory_format=torch.channels_last))
        loss = umbra_net.loss_of(scores, visibility)
        optimizer.zero_grad(set_to_none=True)
        loss.backward()
        nn.utils.clip_grad_norm_(net.parameters(), 1.)
        optimizer.step()
        mean.follow(step)
        step += 1
        if step % 50 == 0:  # seldom: to ask for a number is to wait for the GPU
            smooth_loss = .9 * smooth_loss + .1 * float(loss) if smooth_loss else float(loss)
        if smooth_loss and time.time() - shown > REPORT_SECONDS:
            shown = time.time()
            print(f'step {step}, {done:.0%}, loss {smooth_loss:.3f}', flush=True)
            judge(net, held, (0,), 'now')
    print(f'{step} steps of {BATCH} lights', flush=True)
    return mean.net


def folded(block):
    """A block with its normalisations put into the convolutions."""
    layers = []
    for i in (0, 3):
        layers += [nn.utils.fusion.fuse_conv_bn_eval(block[i], block[i + 1]), nn.ReLU()]
    return nn.Sequential(*layers)


def export(net, path):
    """As ONNX with height and width left open: opset 11 is what OpenCV 4.6 reads."""
    net = copy.deepcopy(net).cpu().eval()
    for blocks in (net.encoder, net.decoder):
        for i, block in enumerate(blocks):
            blocks[i] = folded(block)
    axes = {2: 'height', 3: 'width'}
    # Newer versions of PyTorch have two exporters; this is the older one.
    older = {'dynamo': False} if 'dynamo' in inspect.signature(torch.onnx.export).parameters else {}
    torch.onnx.export(net, torch.zeros(1, umbra_net.EVIDENCE, 224, 384), str(path), opset_version=11,
                      input_names=['evidence'], output_names=['told'],
                      dynamic_axes={'evidence': axes, 'told': axes}, **older)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('out', type=pathlib.Path)
    arguments.add_argument('packs', nargs='*', metavar='PACK,WIDTH,HEIGHT[,SHARE]')
    arguments.add_argument('--seconds', type=float)
    arguments.add_argument('--judge', action='append', default=[], metavar='PACK,WIDTH,HEIGHT')
    arguments.add_argument('--export', metavar='WEIGHTS')
    a = arguments.parse_args()
    if not a.export and not (a.seconds and a.packs):
        arguments.error('give packs to learn from and the --seconds to train for, or weights to --export')
    torch.backends.cuda.matmul.allow_tf32 = torch.backends.cudnn.allow_tf32 = True
    packs = [Pack(said) for said in a.packs]
    held = [(pack.path, umbra_batches.Sets(pack.held, DEVICE))
            for pack in packs + [Pack(said, all_held=True) for said in a.judge] if pack.held]
    if a.export:
        net = umbra_net.UmbraNet().to(DEVICE)
        net.load_state_dict(torch.load(a.export, map_location=DEVICE))
    else:
        net = train(packs, held, a.seconds)
    judge(net, held, (0, 1.), 'mean of weights' if not a.export else a.export)
    a.out.mkdir(parents=True, exist_ok=True)
    torch.save({name: weight.cpu() for name, weight in net.state_dict().items()}, a.out / 'umbra_network.pt')
    export(net.eval(), a.out / 'umbra_network.onnx')


if __name__ == '__main__':
    main()
