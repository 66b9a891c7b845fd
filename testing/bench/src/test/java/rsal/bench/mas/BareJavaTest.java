package rsal.bench.mas;

import rsal.agent.bare.BareSystem;
import rsal.testkit.contract.BareSystemContract;

class BareJavaTest extends BareSystemContract {
    @Override
    protected BareSystem system() {
        return new BareJava();
    }
}
