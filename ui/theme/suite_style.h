// The color and the displayed name of each suite, the same in charts, on the map, in legends and on the lock. The colors
// come from the suites' descriptors; they are those of Okabe and Ito, distinguishable with color vision deficiencies.
#pragma once

#include "core/crypto/suite.h"

#include <QtCore/QString>
#include <QtGui/QColor>
#include <QtGui/QIcon>

#include <string>

namespace skyseal::ui {

QColor suiteColor(crypto::SuiteId suite);

/// The displayed name. That of a research suite always contains "insecure".
QString suiteName(crypto::SuiteId suite);

/// The displayed name of a suite by its name in files; that name if this build does not know the suite.
QString suiteNameOf(const std::string &nameInFiles);

/// A filled dot in the suite's color.
QIcon suiteDot(crypto::SuiteId suite);

} // namespace skyseal::ui
