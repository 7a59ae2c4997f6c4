#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/capture/response_curve.h"
#include "core/image/image.h"
#include "core/intake/brackets.h"
#include "core/intake/shot_folder.h"

namespace swaplight {

/// Of recovering a response.
enum class ResponseMethod {
  Debevec,    ///< Debevec and Malik 1997: least squares of the logarithm of light
  Robertson,  ///< Robertson, Borman and Stevenson 2003: of light itself
};

/// A camera's response, recovered from brackets.
struct ResponseFit {
  ResponseCurve curve;  ///< of 256 codes; its light is 1 at code 1 in every channel
  /// RMS of what it leaves, of the light: noise and steps, or a wrong exposure.
  std::array<double, 3> misfit{};
  /// The lowest code, 0..1, that was seen often enough; below it is continued.
  std::array<double, 3> darkest{};
  std::string nearest;           ///< the usual coding that it is most like
  double nearestDifference = 0;  ///< the largest difference from it, of full scale
  double methodDifference = 0;   ///< the same from what the other method finds
};

/// The response of the camera whose pictures these are; it does not fall (pool adjacent violators). `codes`:
/// the pictures as the files hold them, 0..1, in brackets whose exposures are told or stated: what the
/// pictures themselves say of them needs the response. Throws InputError: no brackets, exposures less than a
/// stop apart, too few codes.
[[nodiscard]] ResponseFit fitResponse(const std::vector<Image>& codes, const Brackets& brackets,
                                      ResponseMethod method = ResponseMethod::Debevec);

/// A folder's photographs as their files hold them, for fitResponse. Throws InputError where one is camera
/// raw or floating point: those have no codes.
[[nodiscard]] std::vector<Image> loadCodes(const ShotFolder& folder);

}  // namespace swaplight
