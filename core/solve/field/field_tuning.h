#pragma once

namespace swaplight {

/// What steers the fit of the lamps' colour over the field (drift_fit.h).
struct FieldTuning {
  int across = 256;   ///< pixels that the photographs' larger side is averaged down to
  double work = 6e6;  ///< numbers that the slopes of the matte evidence may take
  int rounds = 3;     ///< of Gauss and Newton's
  int passes = 8;     ///< of the robust fits
  int tiles = 8;      ///< parts of the picture across and down, whose errors are independent
  /// Priors of a coefficient, the logarithm of a colour from the middle to the edge: of the lamps, and of
  /// what the set's own colours go over the picture by themselves. Chosen on photo_shoe, random_1 and
  /// random_7 (the second among .01, .02 and .05; the first: .05 or .1).
  double drift = .05, reflectance = .05;
  double colors = .03;      ///< prior of a lamp's colour being told wrongly, relative
  double modelError = .01;  ///< relative: what the matte model leaves on sets of which all is known
  double matteFreedom = 3;  ///< of Student's t: gloss and bounced light have heavy tails
  double stepFreedom = 1;   ///< the same: edges of surfaces have heavier ones
  double texture = .004;    ///< logarithm of colour between neighbours of one surface, at least
  int neighbours = 40;      ///< steps across the picture over which colours are compared
  double darkest = .03;     ///< of the 95th percentile of brightness: darker pixels are left out
};

}  // namespace swaplight
