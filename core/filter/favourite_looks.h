#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swaplight {

// The camera looks that stand ready in the mixer, by their names, in their order: a small JSON file,
//
//   {"format": "swaplight-favourite-looks", "version": 1, "camera_looks": ["Snow", "Twilight"]}

/// Those of a person who has not chosen yet: the scene types that come along, first the dissertation's.
[[nodiscard]] std::vector<std::string> sceneTypes();

/// favourite-looks.json among the person's things.
[[nodiscard]] std::filesystem::path favouriteLooksFile();
/// The scene types where there is no such file. Throws InputError that names the file: it is none, or of a
/// newer version.
[[nodiscard]] std::vector<std::string> readFavouriteLooks(const std::filesystem::path& file);
/// Throws InputError.
void writeFavouriteLooks(const std::vector<std::string>& names, const std::filesystem::path& file);

/// Names are compared as findPipeline does: whatever their case, with spaces, dashes or underscores.
[[nodiscard]] bool isFavourite(const std::vector<std::string>& names, const std::string& name);
/// With the name as the first one, where it is not there yet.
[[nodiscard]] std::vector<std::string> withFavourite(std::vector<std::string> names, const std::string& name);
[[nodiscard]] std::vector<std::string> withoutFavourite(std::vector<std::string> names,
                                                        const std::string& name);

}  // namespace swaplight
