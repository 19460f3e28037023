#pragma once

#include <QString>
#include <string>

namespace insonate::train {

/// Returns the displayed name of an effect of EffectLayers.h: "shadows behind boundaries".
QString effectWords(const std::string& name);

}  // namespace insonate::train
