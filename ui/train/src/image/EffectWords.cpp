#include "EffectWords.h"

#include <QCoreApplication>

namespace insonate::train {
namespace {

struct Words {
  const char* name;
  const char* words;
};
constexpr Words kWords[] = {
    {"echogenicity", "brightness of tissues"},
    {"reflection", "echoes from boundaries"},
    {"attenuation", "attenuation with depth"},
    {"transmission", "shadows behind boundaries"},
    {"speckle", "speckle"},
    {"beam", "beam width"},
    {"layers", "walls and fasciae"},
    {"texture", "texture within tissues"},
    {"reverberation", "reverberation behind air"},
    {"edge_shadow", "edge shadows"},
    {"clutter", "clutter in vessels"},
    {"noise", "electronic noise"},
    {"near_field", "reverberation in the probe"},
    {"absorption", "attenuation and shadows"},
    {"blur", "blur along the beam"},
};

}  // namespace

QString effectWords(const std::string& name) {
  for (const Words& one : kWords)
    if (name == one.name) return QCoreApplication::translate("EffectWords", one.words);
  return QString::fromStdString(name).replace('_', ' ');
}

}  // namespace insonate::train
