// The project's own icons: line drawings of one weight, painted in the palette's text colour (or a given one) at the
// moment they are shown, so that they follow the theme by themselves.
#pragma once

#include <QtGui/QColor>
#include <QtGui/QIcon>
#include <QtGui/QPixmap>

namespace skyseal::ui {

/// The icon `name` of resources/icons, without suffix. It follows the application's palette.
QIcon icon(const QString &name);

/// The same as a picture of `size` logical pixels in one colour.
QPixmap iconPixmap(const QString &name, int size, const QColor &color, qreal devicePixelRatio);

} // namespace skyseal::ui
