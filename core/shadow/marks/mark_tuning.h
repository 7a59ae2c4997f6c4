#pragma once

#include <tuple>
#include <utility>

namespace swaplight {

/// Of what a person's marks say of the places around them (mark_word.h). Lengths in units (referenceUnit).
struct ShadowMarkTuning {
  float reach = 160;  ///< units over which a word weakens e times on an even surface, unless it is resisted
  float barrier = 1;  ///< what a border of e-fold strength 1 beyond `quiet` weakens it by, as a power of e
  float quiet = .5F;  ///< strength of borders that is noise
  float contrary = .01F;   ///< powers of e in a unit where a log-odds of 1 or more speaks against the word
  float stronger = .5F;    ///< powers of e for each log-odds that speaks more against it than at the mark
  float tolerance = .35F;  ///< log (half a stop): levels so far on the wrong side of the mark's are as good
  float shareBy = .125F;   ///< powers of e: of two marks that contradict, the one so much nearer has the word
  float settled = .5F;     ///< a word from which on it holds against everything else
  float settledRamp = .25F;  ///< beyond which it holds in full
  float hard = .9F;          ///< a word from which on the cut has no choice

  static constexpr auto fields() {
    using T = ShadowMarkTuning;
    return std::tuple{std::pair{"reach", &T::reach},
                      std::pair{"barrier", &T::barrier},
                      std::pair{"quiet", &T::quiet},
                      std::pair{"contrary", &T::contrary},
                      std::pair{"stronger", &T::stronger},
                      std::pair{"tolerance", &T::tolerance},
                      std::pair{"share_by", &T::shareBy},
                      std::pair{"settled", &T::settled},
                      std::pair{"settled_ramp", &T::settledRamp},
                      std::pair{"hard", &T::hard}};
  }
};

}  // namespace swaplight
