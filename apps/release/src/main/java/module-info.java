/// Packs releases of RSAL: `./rsal dist`. Not part of what it packs.
module rsal.release {
    requires info.picocli;
    requires java.net.http;
    requires org.apache.commons.compress;
    requires static org.jspecify;
    requires tools.jackson.databind;

    opens rsal.release to
            info.picocli;
}
