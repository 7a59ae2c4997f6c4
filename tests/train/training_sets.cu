// Draws sets of simple solids under two to five lamps and renders them: each lamp's contribution, and how
// much of the lamp each pixel sees. They teach the network that tells umbra (train_umbra.py).
//
// usage: training_sets FIRST_SEED COUNT WIDTH HEIGHT OUT
//
// OUT gets a set after the other, as packed_set.h says. Built by nvcc it renders on a GPU, by a C++ compiler
// on the CPU; README.md has both commands. The same seeds give the same sets, whatever renders them, but for
// rounding.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/train/location.h"
#include "tests/train/packed_set.h"
#include "tests/train/path_tracer.h"

namespace training {
namespace {

#ifdef __CUDACC__

constexpr int kBatch = 64;
constexpr int kStreams = 8;

__global__ void traceAll(const Scene* scene, int width, int height, float* light, float* seen) {
  const int x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y * blockDim.y + threadIdx.y;
  if (x >= width || y >= height) return;
  const size_t p = size_t(y) * width + x;
  float l[kLightFloats], s[kSeenFloats];
  tracePixel(*scene, width, height, x, y, l, s);
  for (int i = 0; i < scene->lampCount * 3; ++i) light[p * kLightFloats + i] = l[i];
  for (int i = 0; i < scene->lampCount * 2; ++i) seen[p * kSeenFloats + i] = s[i];
}

/// Renders batches of scenes side by side on the GPU.
class Renderer {
 public:
  explicit Renderer(size_t pixels) : m_pixels(pixels) {
    cudaMallocManaged(&m_scenes, sizeof(Scene) * kBatch);
    cudaMalloc(&m_light, kBatch * pixels * kLightFloats * sizeof(float));
    cudaMalloc(&m_seen, kBatch * pixels * kSeenFloats * sizeof(float));
    for (cudaStream_t& stream : m_streams) cudaStreamCreate(&stream);
  }

  Scene* scenes() { return m_scenes; }

  bool render(int count, int width, int height, float* light, float* seen) {
    const dim3 block(8, 4), grid((width + 7) / 8, (height + 3) / 4);
    for (int k = 0; k < count; ++k)
      traceAll<<<grid, block, 0, m_streams[k % kStreams]>>>(m_scenes + k, width, height,
                                                            m_light + k * m_pixels * kLightFloats,
                                                            m_seen + k * m_pixels * kSeenFloats);
    cudaDeviceSynchronize();
    if (cudaGetLastError() != cudaSuccess) return false;
    const size_t all = size_t(count) * m_pixels * sizeof(float);
    cudaMemcpy(light, m_light, all * kLightFloats, cudaMemcpyDeviceToHost);
    cudaMemcpy(seen, m_seen, all * kSeenFloats, cudaMemcpyDeviceToHost);
    return cudaGetLastError() == cudaSuccess;
  }

 private:
  size_t m_pixels;
  Scene* m_scenes = nullptr;
  float *m_light = nullptr, *m_seen = nullptr;
  cudaStream_t m_streams[kStreams];
};

#else

constexpr int kBatch = 1;

/// Renders one scene at a time on all cores.
class Renderer {
 public:
  explicit Renderer(size_t) : m_scenes(kBatch) {}

  Scene* scenes() { return m_scenes.data(); }

  bool render(int, int width, int height, float* light, float* seen) {
#pragma omp parallel for schedule(dynamic)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const size_t p = size_t(y) * width + x;
        tracePixel(m_scenes[0], width, height, x, y, &light[p * kLightFloats], &seen[p * kSeenFloats]);
      }
    return true;
  }

 private:
  std::vector<Scene> m_scenes;
};

#endif

int writeSets(uint32_t firstSeed, int count, int width, int height, const char* path) {
  FILE* const out = std::fopen(path, "wb");
  if (!out) {
    std::fprintf(stderr, "%s: cannot be written.\n", path);
    return 1;
  }
  const size_t pixels = size_t(width) * size_t(height);
  Renderer renderer(pixels);
  std::vector<float> light(kBatch * pixels * kLightFloats), seen(kBatch * pixels * kSeenFloats);
  for (int begin = 0; begin < count; begin += kBatch) {
    const int some = std::min(kBatch, count - begin);
    for (int k = 0; k < some; ++k)
      renderer.scenes()[k] = drawScene(firstSeed + uint32_t(begin + k), float(height) / float(width));
    if (!renderer.render(some, width, height, light.data(), seen.data())) {
      std::fprintf(stderr, "The GPU failed on the sets from seed %u on.\n", firstSeed + uint32_t(begin));
      return 1;
    }
    std::vector<std::vector<uint8_t>> packed(static_cast<size_t>(some));
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < some; ++k)
      packed[size_t(k)] =
          packedSet(renderer.scenes()[k].lampCount, pixels, light.data() + size_t(k) * pixels * kLightFloats,
                    seen.data() + size_t(k) * pixels * kSeenFloats);
    for (const auto& bytes : packed) std::fwrite(bytes.data(), 1, bytes.size(), out);
  }
  return std::fclose(out) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace training

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "usage: training_sets FIRST_SEED COUNT WIDTH HEIGHT OUT\n");
    return 2;
  }
  return training::writeSets(uint32_t(std::atoi(argv[1])), std::atoi(argv[2]), std::atoi(argv[3]),
                             std::atoi(argv[4]), argv[5]);
}
