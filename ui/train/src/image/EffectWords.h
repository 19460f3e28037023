#pragma once

#include <QString>
#include <string>

namespace insonate::train {

/// Name of an effect of EffectLayers.h in the window: "shadows behind boundaries".
QString effectWords(const std::string& name);

}  // namespace insonate::train
