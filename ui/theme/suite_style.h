// One colour and one written name for each suite, the same in charts, on the map, in legends and on the lock. The
// colours are Okabe and Ito's, which stay apart for colour-blind eyes.
#pragma once

#include "core/crypto/suite.h"

#include <QtCore/QString>
#include <QtGui/QColor>
#include <QtGui/QIcon>

#include <array>

namespace skyseal::ui {

/// The suites an operator can choose, in the order in which they are shown; research suites last.
inline constexpr std::array kChoosableSuites{crypto::SuiteId::ChaCha20Poly1305, crypto::SuiteId::Aes256Gcm,
                                             crypto::SuiteId::Aes256Ctr,        crypto::SuiteId::Aes256Cbc,
                                             crypto::SuiteId::ChaCha20,         crypto::SuiteId::Rc4};

QColor suiteColor(crypto::SuiteId suite);

/// The name for people. A research suite carries the word "insecure", everywhere.
QString suiteName(crypto::SuiteId suite);

/// A filled dot in the suite's colour.
QIcon suiteDot(crypto::SuiteId suite);

} // namespace skyseal::ui
