package rsal.server.http;

import io.javalin.config.RoutesConfig;
import io.javalin.http.Handler;

/// What can be asked below an address.
///
/// @param at that address, which may have parameters; empty for the server's own
public record HttpRoutes(RoutesConfig all, String at) {
    /// @param path of what is asked for, below that address; `*` for all
    public void before(String path, Handler handler) {
        all.before(at + path, handler);
    }

    public void get(String path, Handler handler) {
        all.get(at + path, handler);
    }

    public void post(String path, Handler handler) {
        all.post(at + path, handler);
    }

    public void put(String path, Handler handler) {
        all.put(at + path, handler);
    }

    public void delete(String path, Handler handler) {
        all.delete(at + path, handler);
    }
}
