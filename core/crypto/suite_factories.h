// One function per suite file; the table in suite.cpp names them.
#pragma once

#include "core/crypto/inline_cipher.h"
#include "core/crypto/record_keys.h"

namespace skyseal::crypto {

using CipherFactory = std::unique_ptr<RecordCipher> (*)(const RecordKeys &keys);

std::unique_ptr<RecordCipher> makeChaCha20Poly1305(const RecordKeys &keys);
std::unique_ptr<RecordCipher> makeAes256Gcm(const RecordKeys &keys);
std::unique_ptr<RecordCipher> makeAes256Ctr(const RecordKeys &keys);
std::unique_ptr<RecordCipher> makeAes256Cbc(const RecordKeys &keys);
std::unique_ptr<RecordCipher> makeChaCha20(const RecordKeys &keys);
std::unique_ptr<RecordCipher> makeRc4(const RecordKeys &keys);

using InlineCipherFactory = std::unique_ptr<InlineCipher> (*)(const RecordKeys &keys);

std::unique_ptr<InlineCipher> makeInlineAes256Ctr(const RecordKeys &keys);
std::unique_ptr<InlineCipher> makeInlineAes256Cbc(const RecordKeys &keys);
std::unique_ptr<InlineCipher> makeInlineChaCha20(const RecordKeys &keys);
std::unique_ptr<InlineCipher> makeInlineRc4(const RecordKeys &keys);

/// The cipher under given keys instead of derived ones: published vectors are checked through it.
std::unique_ptr<RecordCipher> makeRecordCipherFromKeys(SuiteId suite, RecordKeys &&keys);

} // namespace skyseal::crypto
