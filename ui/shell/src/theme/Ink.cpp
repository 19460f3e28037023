#include <insonate/ui/Ink.h>
#include <insonate/ui/Theme.h>

namespace insonate::ui {

Ink screenInk() {
  namespace theme = views::theme;
  return {.ground = toQColor(theme::kGround),
          .text = toQColor(theme::kText),
          .quiet = toQColor(theme::kQuiet),
          .line = toQColor(theme::kLine),
          .grid = toQColor(theme::kLine),
          .band = toQColor(theme::kRaised),
          .accent = toQColor(theme::kAccent),
          .good = toQColor(theme::kGood),
          .caution = toQColor(theme::kCaution),
          .danger = toQColor(theme::kDanger)};
}

Ink paperInk() {
  return {.ground = Qt::white,
          .text = {0x1a, 0x1e, 0x23},
          .quiet = {0x55, 0x5f, 0x68},
          .line = {0xb4, 0xbc, 0xc4},
          .grid = {0xd5, 0xda, 0xdf},
          .band = {0xe6, 0xea, 0xee},
          .accent = {0x1b, 0x6a, 0xa5},
          .good = {0x1f, 0x7a, 0x4b},
          .caution = {0xa8, 0x6c, 0x00},
          .danger = {0xb3, 0x26, 0x1e}};
}

}  // namespace insonate::ui
