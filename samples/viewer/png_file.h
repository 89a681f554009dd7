#pragma once

#include <string>

namespace palpate::viewer {

// Writes the bound framebuffer as a PNG file. Throws cli::Failure.
void write_screenshot(const std::string& path, int width, int height);

}  // namespace palpate::viewer
