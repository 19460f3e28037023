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
    {"reflection", "echoes of boundaries"},
    {"attenuation", "loss with depth"},
    {"transmission", "shadows behind boundaries"},
    {"speckle", "speckle"},
    {"beam", "width of the beam"},
    {"layers", "walls and fasciae"},
    {"texture", "texture within tissues"},
    {"reverberation", "echoes behind air"},
    {"edge_shadow", "shadows of edges"},
    {"clutter", "haze in vessels"},
    {"noise", "electronic noise"},
    {"near_field", "ringing of the probe"},
    {"absorption", "loss and shadows"},
    {"blur", "blur along the beam"},
};

}  // namespace

QString effectWords(const std::string& name) {
  for (const Words& one : kWords)
    if (name == one.name) return QCoreApplication::translate("EffectWords", one.words);
  return QString::fromStdString(name).replace('_', ' ');
}

}  // namespace insonate::train
