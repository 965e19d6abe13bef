#include "renderer/video/WebVtt.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <set>

#include "renderer/image/WholeFile.hpp"

namespace thinwall {
namespace {

long long milliseconds(double seconds) {
  return std::llround(seconds * 1000);
}

std::string time_text(long long time) {
  char text[48];
  std::snprintf(text, sizeof(text), "%02lld:%02lld:%02lld.%03lld", time / 3600000, time / 60000 % 60, time / 1000 % 60,
                time % 1000);
  return text;
}

/// Escapes what the format reads as markup; an empty line would end the caption.
std::string cue_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '\n' || c == '\r') {
      if (!result.empty() && result.back() != '\n') result += '\n';
    } else if (c != '\0') {
      result += c;
    }
  }
  while (!result.empty() && result.back() == '\n') result.pop_back();
  return result;
}

}  // namespace

std::string web_vtt(const std::vector<VideoCaption>& captions) {
  std::string file = "WEBVTT\n";
  for (const VideoCaption& caption : captions) {
    const long long begin = milliseconds(caption.begin);
    const long long end = milliseconds(caption.end);
    const std::string text = cue_text(caption.text);
    if (text.empty() || end <= begin) continue;
    file += "\n" + time_text(begin) + " --> " + time_text(end) + "\n" + text + "\n";
  }
  return file;
}

std::vector<VideoCaption> one_at_a_time(const std::vector<VideoCaption>& captions) {
  std::set<double> times;
  for (const VideoCaption& caption : captions) times.insert({caption.begin, caption.end});
  std::vector<VideoCaption> shown;
  const VideoCaption* before = nullptr;
  for (auto time = times.begin(); time != times.end() && std::next(time) != times.end(); ++time) {
    const double end = *std::next(time);
    const auto holds = [&](const VideoCaption& caption) { return caption.begin <= *time && caption.end >= end; };
    const auto last = std::find_if(captions.rbegin(), captions.rend(), holds);
    const VideoCaption* caption = last == captions.rend() ? nullptr : &*last;
    if (caption != nullptr && caption == before) {
      shown.back().end = end;
    } else if (caption != nullptr) {
      shown.push_back({*time, end, caption->text});
    }
    before = caption;
  }
  return shown;
}

void write_web_vtt(const std::filesystem::path& path, const std::vector<VideoCaption>& captions) {
  write_whole_file(path, web_vtt(one_at_a_time(captions)));
}

}  // namespace thinwall
