#include "core/image/io/picture_process.h"

#include <OpenImageIO/imageio.h>

#include <array>
#include <optional>
#include <type_traits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/io/image_format.h"
#include "core/image/io/picture_decoder.h"
#include "core/image/io/picture_message.h"
#include "core/sandbox/shared_memory.h"

namespace swaplight {
namespace {

constexpr size_t kLongestMessage = size_t{64} << 20;
constexpr int kProcessorSeconds = 600;  // no photograph takes a tenth of it
constexpr int kSlots = 2;               // one is decoded while the other is taken

// A sanitizer watches one process, and takes more memory than a decoder is given.
#ifdef SWAPLIGHT_SANITIZE
constexpr bool kWatched = true;
#else
constexpr bool kWatched = false;
#endif

std::unique_ptr<HelperProcesses>& processes() {
  static std::unique_ptr<HelperProcesses> made;
  return made;
}

/// Loads what every decoder needs, so that each process begins with it.
void prepareDecoders() {
  for (const char* format : {"openexr", "png", "tiff", "jpeg", "hdr", "raw"})
    static_cast<void>(OIIO::ImageInput::create(format));
  static_cast<void>(OIIO::geterror());
}

/// Decodes all bands into the shared memory, a slot ahead of who takes them. False where nobody takes them.
bool sendBands(const Channel& channel, PictureDecoder& decoder, const SharedMemory& memory) {
  const size_t bandBytes = decoder.bandBytes();
  for (int count = 0;; ++count) {
    if (count >= kSlots && !channel.receive(0)) return false;  // until the slot is free
    const int slot = count % kSlots;
    const auto band = decoder.next(memory.data() + static_cast<size_t>(slot) * bandBytes);
    if (!band) return true;
    if (!channel.send(messageOf(BandAnswer{*band, slot, false}))) return false;
  }
}

/// The other process: one picture, then the end.
void decodeFor(const Channel& channel) {
  const auto asked = channel.receive(kLongestMessage);
  if (!asked) return;
  try {
    const PictureRequest request = pictureRequestOf(*asked);
    setThreads(request.threads);
    std::optional<PictureDecoder> decoder(std::in_place, request.file);
    if (!channel.send(messageOf(PictureAnswer{decoder->contents(), decoder->bandBytes()}))) return;
    OwnedDescriptor descriptor;
    if (!channel.receive(0, &descriptor) || !descriptor) return;
    const SharedMemory memory(std::move(descriptor), kSlots * decoder->bandBytes());
    if (!sendBands(channel, *decoder, memory)) return;
    // A decoder that wrote beyond its memory dies here, if not before: its picture is not to be believed.
    decoder.reset();
    static_cast<void>(channel.send(messageOf(BandAnswer{{}, 0, true})));
  } catch (...) {
    static_cast<void>(channel.send(messageOf(std::current_exception())));
  }
}

class PictureApart : public PictureSource {
 public:
  PictureApart(const std::filesystem::path& file, Channel channel)
      : m_name(file.string()), m_channel(std::move(channel)) {
    if (!m_channel.send(messageOf(PictureRequest{file, threadCount()}))) died();
    m_answer = checked([&](const std::string& message) { return pictureAnswerOf(message, m_name); });
  }

  [[nodiscard]] const PictureContents& contents() const override { return m_answer.contents; }

  void eachBand(const Take& take) override {
    const SharedMemory memory(kSlots * m_answer.bandBytes);
    if (!m_channel.send({}, memory.descriptor())) died();
    while (true) {
      const BandAnswer answer =
          checked([&](const std::string& message) { return bandAnswerOf(message, m_answer); });
      if (answer.last) return;
      take(answer.band, memory.data() + static_cast<size_t>(answer.slot) * m_answer.bandBytes);
      static_cast<void>(
          m_channel.send({}));  // the slot is free; that nobody waits for it is said by what follows
    }
  }

 private:
  [[noreturn]] void died() const {
    throw InputError(
        "{}: cannot be decoded: it crashed its decoder, or takes more time or memory than any picture. It is "
        "damaged, or made to do harm. Save it anew from the program that made it.",
        m_name);
  }

  /// The next message, read; what is no such message comes from a process that is no longer ours.
  template <typename Read>
  std::invoke_result_t<Read, const std::string&> checked(const Read& read) const {
    const auto message = m_channel.receive(kLongestMessage);
    if (!message) died();
    try {
      return read(*message);
    } catch (const InputError&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {
      died();
    }
  }

  std::string m_name;
  Channel m_channel;
  PictureAnswer m_answer;
};

}  // namespace

PictureProcesses::PictureProcesses() {
  if constexpr (!kWatched) {
    const auto memory = static_cast<size_t>(0.75e9 * machineGigabytes());
    processes() = std::make_unique<HelperProcesses>(
        HelperProcesses::Work{prepareDecoders, decodeFor, {memory, kProcessorSeconds}});
  }
}

PictureProcesses::~PictureProcesses() {
  processes().reset();
}

const char* pictureProcessWords() {
  return processes() ? confinementWords() : "in the program itself";
}

std::unique_ptr<PictureSource> openPictureApart(const std::filesystem::path& file) {
  if (!processes()) return nullptr;
  return std::make_unique<PictureApart>(file, processes()->start());
}

}  // namespace swaplight
