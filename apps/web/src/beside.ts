import { mount } from 'svelte';
import BesideView from './beside/BesideView.svelte';
import './app.css';

mount(BesideView, { target: document.getElementById('app')! });
