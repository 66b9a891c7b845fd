package rsal.server;

import io.javalin.config.RoutesConfig;
import io.javalin.http.Handler;

/// What can be asked below an address.
///
/// @param at that address, which may have parameters; empty for the server's own
record Routes(RoutesConfig all, String at) {
    /// @param path of what is asked for, below that address; `*` for all
    void before(String path, Handler handler) {
        all.before(at + path, handler);
    }

    void get(String path, Handler handler) {
        all.get(at + path, handler);
    }

    void post(String path, Handler handler) {
        all.post(at + path, handler);
    }

    void put(String path, Handler handler) {
        all.put(at + path, handler);
    }

    void delete(String path, Handler handler) {
        all.delete(at + path, handler);
    }
}
