package rsal.bench.bare;

import rsal.bare.BareSystem;
import rsal.testkit.contract.BareSystemContract;

class BareJadeTest extends BareSystemContract {
    @Override
    protected BareSystem system() {
        return new BareJade();
    }
}
