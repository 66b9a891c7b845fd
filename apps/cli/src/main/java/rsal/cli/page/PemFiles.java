package rsal.cli.page;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.PublicKey;
import java.security.Signature;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.security.spec.PKCS8EncodedKeySpec;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A certificate and its private key in files, as other servers have them: PEM (RFC 7468), the key unencrypted in PKCS
/// #8.
final class PemFiles {
    private static final Pattern KEY =
            Pattern.compile("-----BEGIN PRIVATE KEY-----([A-Za-z0-9+/=\\s]+)-----END PRIVATE KEY-----");
    private static final Map<String, String> SIGNATURES =
            Map.of("EC", "SHA256withECDSA", "RSA", "SHA256withRSA", "EdDSA", "EdDSA");
    private static final String CONVERT =
            "'openssl pkcs8 -topk8 -nocrypt -in KEY -out FILE.pem' turns other forms of keys into it.";

    private PemFiles() {}

    /// @return both, without a password
    /// @throws InvalidSettings when a file is none such, or they do not belong together
    static KeyStore identity(Path certificate, Path key) {
        List<? extends Certificate> chain = chain(certificate);
        PrivateKey secret = key(key);
        if (!belong(chain.getFirst().getPublicKey(), secret)) {
            throw new InvalidSettings(
                    Location.of(key.toString()),
                    "This key is not that of the certificate '%s'.".formatted(certificate),
                    "");
        }
        try {
            KeyStore store = KeyStore.getInstance("PKCS12");
            store.load(null, null);
            store.setKeyEntry("rsal", secret, new char[0], chain.toArray(new Certificate[0]));
            return store;
        } catch (GeneralSecurityException | IOException e) {
            throw new IllegalStateException(e); // in memory
        }
    }

    private static List<? extends Certificate> chain(Path file) {
        try {
            List<? extends Certificate> chain = List.copyOf(CertificateFactory.getInstance("X.509")
                    .generateCertificates(new ByteArrayInputStream(text(file).getBytes(StandardCharsets.UTF_8))));
            if (!chain.isEmpty()) {
                return chain;
            }
        } catch (GeneralSecurityException _) {
            // told below
        }
        throw new InvalidSettings(
                Location.of(file.toString()), "This is not a certificate in PEM.", "'rsal certificate' makes one.");
    }

    private static PrivateKey key(Path file) {
        Matcher key = KEY.matcher(text(file));
        if (key.find()) {
            byte[] bytes = Base64.getMimeDecoder().decode(key.group(1));
            for (String kind : SIGNATURES.keySet()) {
                try {
                    return KeyFactory.getInstance(kind).generatePrivate(new PKCS8EncodedKeySpec(bytes));
                } catch (GeneralSecurityException _) {
                    // maybe of another kind
                }
            }
        }
        throw new InvalidSettings(
                Location.of(file.toString()), "This is not an unencrypted private key in PEM (PKCS #8).", CONVERT);
    }

    /// Whether what one signs the other confirms.
    private static boolean belong(PublicKey open, PrivateKey secret) {
        try {
            byte[] words = {1, 2, 3};
            Signature signature = Signature.getInstance(SIGNATURES.getOrDefault(secret.getAlgorithm(), "EdDSA"));
            signature.initSign(secret);
            signature.update(words);
            byte[] signed = signature.sign();
            signature.initVerify(open);
            signature.update(words);
            return signature.verify(signed);
        } catch (GeneralSecurityException e) {
            return false;
        }
    }

    private static String text(Path file) {
        try {
            return Files.readString(file, StandardCharsets.ISO_8859_1);
        } catch (NoSuchFileException _) {
            throw new InvalidSettings(
                    Location.of(file.toString()),
                    "There is no file '%s'.".formatted(file),
                    "'rsal certificate' makes a certificate and its key.");
        } catch (IOException e) {
            throw new InvalidSettings(Location.of(file.toString()), "This file can't be read: %s.".formatted(e), "");
        }
    }
}
