#pragma once

#include <insonate/views/Theme.h>

#include <QPixmap>

namespace insonate::prepare {

/// Returns a small square in a structure's color.
QPixmap swatch(views::Colour colour);

}  // namespace insonate::prepare
