#include "samples/viewer/png_file.h"

#include <cstddef>
#include <vector>

#include <epoxy/gl.h>
#include <stb_image_write.h>

#include "samples/cli/failure.h"

namespace palpate::viewer {

void write_screenshot(const std::string& path, int width, int height) {
  constexpr int kChannels = 3;
  const int row = kChannels * width;
  std::vector<unsigned char> pixels(static_cast<std::size_t>(row) * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  // OpenGL's first row is the lowest.
  const unsigned char* const top = pixels.data() + static_cast<std::ptrdiff_t>(row) * (height - 1);
  if (!stbi_write_png(path.c_str(), width, height, kChannels, top, -row))
    throw cli::Failure(path + ": cannot be written");
}

}  // namespace palpate::viewer
