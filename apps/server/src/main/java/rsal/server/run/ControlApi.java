package rsal.server.run;

import io.javalin.http.Context;
import io.javalin.http.Handler;
import io.javalin.http.Header;
import rsal.server.http.AccessControl;
import rsal.server.http.Http;
import rsal.server.http.HttpRoutes;
import rsal.server.message.Messages.Control;
import rsal.server.message.Messages.ControlWish;

/// Who has control, of this server and all of its runs.
public final class ControlApi {
    private final AccessControl gate;

    public ControlApi(AccessControl gate) {
        this.gate = gate;
    }

    public void configure(HttpRoutes routes) {
        routes.get("/api/control", this::control);
        routes.post("/api/control", controlled(request -> {
            ControlWish wish = Http.read(request, ControlWish.class);
            gate.lease().take(Http.operator(request), wish.name(), wish.over());
        }));
        routes.put("/api/control", controlled(request -> gate.lease().keep(Http.operator(request))));
        routes.delete("/api/control", controlled(request -> gate.lease().giveBack(Http.operator(request))));
    }

    /// Changes who has control, with the token, and answers who has it then.
    private Handler controlled(Handler change) {
        return request -> {
            gate.authorize(request.header(Header.AUTHORIZATION));
            change.handle(request);
            control(request);
        };
    }

    private void control(Context request) {
        Http.answer(request, new Control(gate.lease().holder(), gate.lease().isHeldBy(Http.operator(request))));
    }
}
