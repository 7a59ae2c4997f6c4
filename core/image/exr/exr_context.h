#pragma once

#include <openexr.h>

namespace swaplight {

/// An open file of the OpenEXR core library; closed with its scope. Move-free: hold it where it is made.
class ExrContext {
 public:
  ExrContext() = default;
  ExrContext(const ExrContext&) = delete;
  ExrContext& operator=(const ExrContext&) = delete;
  ~ExrContext() {
    if (m_context) exr_finish(&m_context);
  }

  exr_result_t startRead(const char* file) {
    const exr_context_initializer_t quiet = initializer();
    return exr_start_read(&m_context, file, &quiet);
  }
  exr_result_t startWrite(const char* file) {
    const exr_context_initializer_t quiet = initializer();
    return exr_start_write(&m_context, file, EXR_WRITE_FILE_DIRECTLY, &quiet);
  }
  /// Closes; what was written is complete only then.
  exr_result_t finish() { return exr_finish(&m_context); }
  [[nodiscard]] exr_context_t get() const { return m_context; }

 private:
  static exr_context_initializer_t initializer() {
    exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
    init.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};  // the default one prints
    return init;
  }
  exr_context_t m_context = nullptr;
};

}  // namespace swaplight
