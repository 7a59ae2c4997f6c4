#pragma once

namespace swaplight {

/// What the viewer shows of a set.
struct ViewSubject {
  enum class Kind {
    Relit,         ///< the frame under the rig
    Contribution,  ///< one light's, at unit white
    Beta,          ///< one light's proportion, 0..1 as grey
    Reflectance,   ///< the set without its lighting
    Residual,      ///< in units of the noise: 1 is as good as it allows
    Sigma,         ///< the relative standard error of the solve
    Flags,         ///< quality.flags, a colour a bit
    Photograph,    ///< a shot as taken
    Visibility,    ///< how much of a light each pixel sees, 0..1 as grey
    Illumination,  ///< one light's on the set, without texture, at unit white
    Lighting,      ///< that of all lights under the rig
    Highlight,     ///< one light's highlights, at unit white
    Diffuse,       ///< one light without its highlights, at unit white
  };
  Kind kind = Kind::Relit;
  int index = 0;  ///< light or shot
  bool operator==(const ViewSubject&) const = default;
};

}  // namespace swaplight
