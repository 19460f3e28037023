#pragma once

#include <QString>
#include <string>

namespace insonate::train {

/// What an effect of EffectLayers.h is called in the window: "shadows behind boundaries".
QString effectWords(const std::string& name);

}  // namespace insonate::train
