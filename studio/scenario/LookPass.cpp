#include "studio/scenario/LookPass.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

#include "renderer/look/OrganLooks.hpp"

namespace thinwall {
namespace {

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// What the body and its mesh are called; a line break parts them, which no organ's name holds.
std::string names_of(const CheckedMember& body) {
  std::string names = body.key;
  const CheckedValue* surface = body.value.find("surface");
  const CheckedValue* mesh = surface == nullptr ? nullptr : surface->find("mesh");
  if (mesh != nullptr) names += '\n' + std::filesystem::path(mesh->text).stem().string();
  return in_small_letters(names);
}

std::string organ_of(const CheckedMember& body) {
  const std::string names = names_of(body);
  for (const OrganLook& organ : organ_looks()) {
    if (names.find(organ.organ) != std::string::npos) return std::string(organ.organ);
  }
  return std::string(organ_looks().front().organ);
}

CheckedValue& look_of(const std::string& body, CheckedValue& looks) {
  if (looks.find(body) == nullptr) {
    looks.members.push_back(
        {.key = body, .location = looks.location, .value = {.location = looks.location, .given = false}});
  }
  return *looks.find(body);
}

double lamp_of(const CheckedValue* camera) {
  const CheckedValue* kind = camera == nullptr ? nullptr : camera->find("kind");
  return kind != nullptr && kind->text == "endoscope" ? 1 : 0;
}

void give_lamp(CheckedValue& owner, const char* key, double strength) {
  owner.members.push_back(
      {.key = key,
       .location = owner.location,
       .value = {.kind = CheckedKind::kNumber, .location = owner.location, .given = false, .number = strength}});
}

/// An endoscope brings its lamp along, each of several its own.
void light_endoscopes(CheckedValue& root) {
  CheckedValue* lights = root.find("lights");
  if (lights == nullptr || lights->find("endoscope") != nullptr) return;
  give_lamp(*lights, "endoscope", lamp_of(root.find("camera")));
  CheckedValue* cameras = root.find("cameras");
  if (cameras == nullptr) return;
  for (CheckedMember& camera : cameras->members) {
    if (camera.value.find("lamp") == nullptr) give_lamp(camera.value, "lamp", lamp_of(&camera.value));
  }
}

}  // namespace

void look_pass(CheckedValue& root) {
  light_endoscopes(root);
  CheckedValue* look = root.find("look");
  CheckedValue* looks = look == nullptr ? nullptr : look->find("bodies");
  const CheckedValue* bodies = root.find("bodies");
  if (looks == nullptr || bodies == nullptr) return;
  for (const CheckedMember& body : bodies->members) {
    CheckedValue& value = look_of(body.key, *looks);
    if (value.find("organ") != nullptr) continue;
    value.members.insert(
        value.members.begin(),
        {.key = "organ",
         .location = value.location,
         .value = {.kind = CheckedKind::kText, .location = value.location, .given = false, .text = organ_of(body)}});
  }
}

}  // namespace thinwall
