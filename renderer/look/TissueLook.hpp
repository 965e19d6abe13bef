#pragma once

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// The cut through a wall, from outside to inside.
struct WallLayers {
  Double3 outer = {0.78, 0.58, 0.51};   // sRGB, 0 to 1, like the others: serosa, or epidermis
  Double3 middle = {0.50, 0.13, 0.11};  // muscle, or dermis
  Double3 inner = {0.86, 0.46, 0.41};   // mucosa, or fat
  double outer_part = 0.12;             // of the thickness
  double inner_part = 0.28;             // of the thickness
  double grain_size = 0.0022;           // metres at most, of bundles and lobules; at least 1.1 mm
};

/// What fills an organ, as it is seen where the organ is open.
struct FluidLook {
  Double3 color = {0.95, 0.88, 0.66};  // sRGB, 0 to 1, of a deep layer
  double clarity = 0.08;               // metres in which a third of the light is left; 0: nothing is seen of it
  double cloudiness = 0.05;            // 0 to 1, part of what a layer takes of the light that it sends back
};

/// How a wall looks. Lengths are those of the stress-free wall, so the pattern sticks to the tissue.
struct TissueLook {
  Double3 color = {0.68, 0.37, 0.32};  // sRGB, 0 to 1, like all colours here
  double roughness = 0.45;             // 0 to 1, of the tissue below the wet layer
  double wetness = 0.7;                // 0 to 1, strength of the wet layer
  double lamp_size = 1;                // of the studio's lamps as the wet layer mirrors them, over what they are
  double mottling = 1;                 // 0 to 1, strength of all that makes the pattern and the fine relief
  double patches = 0.85;               // 0 to 1, contrast of redder and paler patches
  double patch_size = 0.013;           // metres
  Double3 blood = {0.50, 0.11, 0.12};  // of vessels
  double vessels = 0.85;               // 0 to 1, strength of vessels with branches
  double vessel_spacing = 0.0095;      // metres
  double capillaries = 0.65;           // 0 to 1, strength of the finest branches
  Double3 fat = {0.86, 0.72, 0.42};
  double fattiness = 0;                        // 0 to 1, part of the wall that fat covers
  Double3 through = {0.40, 0.10, 0.09};        // what shines through a thin wall
  double clearness = 0.2;                      // 0 to 1, part of the light that the stress-free wall lets through
  Double3 scatter = {0.0030, 0.0013, 0.0009};  // metres that red, green and blue light travel within the tissue
  double sheen = 0.3;                          // 0 to 1, veil of the outermost layer where the look is along it
  double relief = 0.10;                        // slope of the fine relief
  double relief_size = 0.0013;                 // metres
  double creases = 0;                          // 0 to 1: from rounded to furrowed relief
  double pores = 0;                            // 0 to 1, strength of pores and of veins below the skin
  double ridges = 0;                           // slope of friction ridges, as of fingers
  double folds = 0;                            // 0 to 1, how high the lining lies in folds where it is not stretched
  WallLayers layers = {};
  FluidLook contents = {};
  double bleeding = 1;  // 0 to 1, how freely the wall bleeds where it is cut
  double bed = 0;       // metres from an open sheet down to the fat and fascia that it lies on; 0: none
};

}  // namespace thinwall
