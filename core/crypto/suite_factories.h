// One function per suite file; the table in suite.cpp names them.
#pragma once

#include "core/crypto/record_cipher.h"

namespace skyseal::crypto {

using CipherFactory = std::unique_ptr<RecordCipher> (*)(const DirectionSecret &secret);

std::unique_ptr<RecordCipher> makeChaCha20Poly1305(const DirectionSecret &secret);
std::unique_ptr<RecordCipher> makeAes256Gcm(const DirectionSecret &secret);
std::unique_ptr<RecordCipher> makeAes256Ctr(const DirectionSecret &secret);
std::unique_ptr<RecordCipher> makeAes256Cbc(const DirectionSecret &secret);
std::unique_ptr<RecordCipher> makeChaCha20(const DirectionSecret &secret);
std::unique_ptr<RecordCipher> makeRc4(const DirectionSecret &secret);

} // namespace skyseal::crypto
