"""Captures whose files are coded as cameras code them: gamma, the Rec.709 curve, logs, wide primaries"""
import numpy as np
import cli


def gamma22(light):
    return np.clip(light, 0, 1) ** (1 / 2.2)


def gamma24(light):
    return np.clip(light, 0, 1) ** (1 / 2.4)


def rec709(light):
    light = np.clip(light, 0, 1)
    return np.where(light < .018, 4.5 * light, 1.099 * np.maximum(light, 1e-9) ** .45 - .099)


def slog3(light):
    """Sony's S-Log3: 18 % grey is code 420 of 1023."""
    return np.where(light >= .01125, (420 + np.log10((light + .01) / .19) * 261.5) / 1023,
                    (light * (171.2102946929 - 95) / .01125 + 95) / 1023)


D65 = np.array([.3127 / .3290, 1, .3583 / .3290])
D60 = np.array([.32168 / .33767, 1, .34065 / .33767])
BRADFORD = np.array([[.8951, .2664, -.1614], [-.7502, 1.7135, .0367], [.0389, -.0685, 1.0296]])
CAT02 = np.array([[.7328, .4296, -.1624], [-.7036, 1.6975, .0061], [.0030, .0136, .9834]])


def primaries(xy):
    p = np.array([[x / y, 1, (1 - x - y) / y] for x, y in xy]).T
    return p * np.linalg.solve(p, D65)


def adaptation(cone, white, other):
    return np.linalg.solve(cone, np.diag((cone @ other) / (cone @ white)) @ cone)


REC709 = primaries([(.64, .33), (.30, .60), (.15, .06)])
SGAMUT3_CINE = primaries([(.766, .275), (.225, .8), (.089, -.087)])


class CodingsTest(cli.CliTest):
    def solved(self, color_space, encode):
        capture = cli.Capture(self.path(color_space), height=48, width=64)
        capture.manifest['color_space'] = color_space
        for k, shot in enumerate(capture.manifest['shots']):
            shot['image'] = f'shot_{k}.png'
        capture.save()
        for shot, pixels in zip(capture.manifest['shots'], capture.shots):
            cli.write_image(self.path(color_space, shot['image']), encode(pixels.astype(float)), 'uint16')
        self.succeed('solve', capture.path, '-o', self.path('solved.exr'), '--float', '-q')
        return capture.truth, [cli.read_rgb(self.path('solved.exr'), name) for name in ('key', 'fill')]

    def close(self, color_space, encode, tolerance=.004):
        truth, found = self.solved(color_space, encode)
        error = np.sqrt(((np.array(found) - truth) ** 2).mean() / (truth ** 2).mean())
        self.assertLess(error, tolerance, color_space)

    def test_curves(self):
        for color_space, encode in (('gamma22', gamma22), ('gamma24', gamma24), ('rec709', rec709)):
            self.close(color_space, encode)

    def test_a_curve_that_is_confused_is_worse(self):
        truth, found = self.solved('gamma22', rec709)
        self.assertGreater(np.sqrt(((np.array(found) - truth) ** 2).mean() / (truth ** 2).mean()), .02)

    def test_a_log_of_a_cinema_camera(self):
        # Through ACES and its white, as Sony's transform goes there (by CAT02) and others from there (Bradford): without
        # that the two whites' adaptations leave .35 % of a channel in another.
        through_aces = adaptation(CAT02, D60, D65) @ adaptation(BRADFORD, D65, D60)
        to_camera = np.linalg.solve(SGAMUT3_CINE, through_aces @ REC709)
        self.close('sony_slog3_sgamut3cine', lambda light: slog3(light @ to_camera.T), .0005)
        self.close('S-Log3 S-Gamut3.Cine', lambda light: slog3(light @ to_camera.T), .0005)

    def test_an_unknown_one_is_refused_and_these_are_listed(self):
        capture = cli.Capture(self.path('set'))
        capture.manifest['color_space'] = 'slog9'
        capture.save()
        self.deny('solve', capture.path, '-o', self.path('x.exr'), naming=['slog9', 'gamma22', 'panasonic_vlog_vgamut'])


if __name__ == '__main__':
    cli.main()
