#include <insonate/ui/Ink.h>
#include <insonate/ui/Theme.h>

namespace insonate::ui {

Ink screenInk() {
  namespace theme = views::theme;
  return {.ground = colour(theme::kGround),
          .text = colour(theme::kText),
          .quiet = colour(theme::kQuiet),
          .line = colour(theme::kLine),
          .grid = colour(theme::kLine),
          .band = colour(theme::kRaised),
          .accent = colour(theme::kAccent),
          .good = colour(theme::kGood),
          .caution = colour(theme::kCaution),
          .danger = colour(theme::kDanger)};
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
