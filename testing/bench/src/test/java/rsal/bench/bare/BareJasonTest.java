package rsal.bench.bare;

import rsal.bare.BareLanguage;
import rsal.testkit.contract.BareLanguageContract;

class BareJasonTest extends BareLanguageContract {
    @Override
    protected BareLanguage language() {
        return new BareJason();
    }
}
