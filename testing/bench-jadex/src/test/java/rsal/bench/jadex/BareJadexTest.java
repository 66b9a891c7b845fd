package rsal.bench.jadex;

import rsal.bare.BareSystem;
import rsal.testkit.contract.BareSystemContract;

class BareJadexTest extends BareSystemContract {
    @Override
    protected BareSystem system() {
        return new BareJadex();
    }
}
