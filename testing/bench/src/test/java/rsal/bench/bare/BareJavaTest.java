package rsal.bench.bare;

import rsal.bare.BareSystem;
import rsal.testkit.contract.BareSystemContract;

class BareJavaTest extends BareSystemContract {
    @Override
    protected BareSystem system() {
        return new BareJava();
    }
}
