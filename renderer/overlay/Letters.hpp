#pragma once

#include <string>

namespace thinwall {

/// The letters of a text that the pinned font has no shape for, each once; nothing of bytes that are no UTF-8.
std::string letters_without_shape(const std::string& text);

}  // namespace thinwall
